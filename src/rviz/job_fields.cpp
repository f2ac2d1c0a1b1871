// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include "rviz/job_fields.h"

#include <QCheckBox>
#include <QDir>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>

#include <utility>

#include "rviz/job_choice.h"
#include "scan_to_path/common/error.h"

namespace scan_to_path_rviz {

JobFields::JobFields(QWidget* parent, std::function<void()> changed) : QWidget(parent), changed_(std::move(changed)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  server_ = add(form, "Server", "server", "job_server", "the cell's job server; relative to rviz's namespace");
  process_ = add(form, "Process", "process", "cutting", "what is done to the part");
  out_ = add(form, "Out", "out", QDir::home().filePath("out/cutting"),
             "directory of the result, where the job server runs");
  region_ = add(form, "Region", "region", "",
                "x_min x_max y_min y_max of a box, or corners x y, x y, x y; m in the workpiece's frame; empty: all");
  skip_rows_ = add(form, "Skip rows", "skip_rows", "", "rows that are not driven, such as 3, 7-9");
  reverse_rows_ = add(form, "Reverse rows", "reverse_rows", "", "rows that are driven the other way round");
  addConfiguration(form);
  review_ = new QCheckBox("wait for accept or reject", this);
  review_->setObjectName("review");
  review_->setToolTip("the path and its verdicts are shown before anything is written");
  form->addRow("Review", review_);
  connect(review_, &QCheckBox::clicked, this, [this] { changed_(); });
}

QLineEdit* JobFields::add(QFormLayout* form, const char* label, const char* name, const QString& text,
                          const char* tip) {
  auto* edit = new QLineEdit(text, this);
  edit->setObjectName(name);
  edit->setToolTip(tip);
  form->addRow(label, edit);
  connect(edit, &QLineEdit::textEdited, this, [this] { changed_(); });
  lines_.push_back(edit);
  return edit;
}

void JobFields::addConfiguration(QFormLayout* form) {
  configuration_ = new QPlainTextEdit(this);
  configuration_->setObjectName("configuration");
  configuration_->setPlaceholderText("path: {pitch: 0.002}");
  configuration_->setToolTip("YAML laid over the cell's configuration for this job; empty: nothing");
  configuration_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  configuration_->setMaximumHeight(4 * fontMetrics().lineSpacing());
  form->addRow("Options", configuration_);
}

scan_to_path::RunJobGoal JobFields::goal() const {
  scan_to_path::RunJobGoal goal;
  goal.process = process_->text().trimmed().toStdString();
  goal.out = out_->text().trimmed().toStdString();
  goal.review = static_cast<std::uint8_t>(review_->isChecked());
  if (!QDir::isAbsolutePath(QString::fromStdString(goal.out))) {
    throw scan_to_path::InputError("out: \"" + goal.out + "\" is no absolute path; the job server runs elsewhere");
  }
  goal.configuration = withChoice(
      configuration_->toPlainText().toStdString(),
      {region_->text().toStdString(), skip_rows_->text().toStdString(), reverse_rows_->text().toStdString()});
  return goal;
}

void JobFields::load(const rviz::Config& config) {
  for (auto* edit : lines_) {
    QString text;
    if (config.mapGetString(edit->objectName(), &text)) edit->setText(text);
  }
  QString yaml;
  if (config.mapGetString(configuration_->objectName(), &yaml)) configuration_->setPlainText(yaml);
  bool review = false;
  if (config.mapGetBool(review_->objectName(), &review)) review_->setChecked(review);
}

void JobFields::save(rviz::Config config) const {
  for (const auto* edit : lines_) config.mapSetValue(edit->objectName(), edit->text());
  config.mapSetValue(configuration_->objectName(), configuration_->toPlainText());
  config.mapSetValue(review_->objectName(), review_->isChecked());
}

}  // namespace scan_to_path_rviz
