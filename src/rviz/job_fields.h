// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rviz/config.h>
#include <scan_to_path/RunJobAction.h>
#include <QWidget>

#include <functional>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLineEdit;
class QPlainTextEdit;

namespace scan_to_path_rviz {

/// What a person says of a job before it runs; kept in the rviz configuration.
class JobFields : public QWidget {
public:
  /// `changed` is called when a person changes what is to be kept.
  JobFields(QWidget* parent, std::function<void()> changed);

  QLineEdit* server() const { return server_; }

  /// Throws InputError, in one line, for what no job server could take.
  scan_to_path::RunJobGoal goal() const;

  void load(const rviz::Config& config);
  void save(rviz::Config config) const;

private:
  QLineEdit* add(QFormLayout* form, const char* label, const char* name, const QString& text, const char* tip);
  void addConfiguration(QFormLayout* form);

  std::function<void()> changed_;
  std::vector<QLineEdit*> lines_;
  QLineEdit* server_ = nullptr;
  QLineEdit* process_ = nullptr;
  QLineEdit* out_ = nullptr;
  QLineEdit* region_ = nullptr;
  QLineEdit* skip_rows_ = nullptr;
  QLineEdit* reverse_rows_ = nullptr;
  QPlainTextEdit* configuration_ = nullptr;
  QCheckBox* review_ = nullptr;
};

}  // namespace scan_to_path_rviz
