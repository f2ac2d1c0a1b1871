// SPDX-FileCopyrightText: 2026 scan_to_path developers
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <rviz/config.h>
#include <rviz/display_factory.h>
#include <rviz/panel_factory.h>
#include <rviz/tool.h>
#include <rviz/view_controller.h>
#include <rviz/yaml_config_reader.h>

#include <filesystem>
#include <memory>
#include <set>

namespace {

/// What is wrong with a configuration of rviz: classes that cannot be made, and settings that our displays do not have.
class Checker {
public:
  std::vector<std::string> check(const rviz::Config& config) {
    const rviz::Config manager = config.mapGetChild("Visualization Manager");
    each(config.mapGetChild("Panels"), [&](const rviz::Config& entry) { check(panels_, entry); });
    each(manager.mapGetChild("Displays"), [&](const rviz::Config& entry) { checkDisplay(entry); });
    each(manager.mapGetChild("Tools"), [&](const rviz::Config& entry) { check(tools_, entry); });
    check(views_, manager.mapGetChild("Views").mapGetChild("Current"));
    return faults_;
  }

  int classes() const { return classes_; }

private:
  template <class Visitor>
  static void each(const rviz::Config& list, const Visitor& visit) {
    for (int i = 0; i < list.listLength(); ++i) visit(list.listChildAt(i));
  }

  /// Ours are made, too: that loads the library. Displays of rviz do not bear an end without a beginning.
  template <class Type>
  std::unique_ptr<Type> check(rviz::PluginlibFactory<Type>& factory, const rviz::Config& entry) {
    QString name;
    entry.mapGetString("Class", &name);
    ++classes_;
    QString error = "no such class";
    std::unique_ptr<Type> made;
    if (name.startsWith("scan_to_path/")) made.reset(factory.make(name, &error));
    if (!made && (name.startsWith("scan_to_path/") || !factory.getDeclaredClassIds().contains(name))) {
      faults_.push_back(name.toStdString() + ": " + error.toStdString());
    }
    return made;
  }

  void checkDisplay(const rviz::Config& entry) {
    const auto display = check(displays_, entry);
    each(entry.mapGetChild("Displays"), [&](const rviz::Config& child) { checkDisplay(child); });
    if (!display) return;
    std::set<QString> known = {"Class", "Name", "Enabled", "Value"};
    for (int i = 0; i < display->numChildren(); ++i) known.insert(display->childAt(i)->getName());
    for (auto it = entry.mapIterator(); it.isValid(); it.advance()) {
      if (known.count(it.currentKey()) == 0) faults_.push_back("no setting " + it.currentKey().toStdString());
    }
  }

  rviz::PanelFactory panels_;
  rviz::DisplayFactory displays_;
  rviz::PluginlibFactory<rviz::Tool> tools_{"rviz", "rviz::Tool"};
  rviz::PluginlibFactory<rviz::ViewController> views_{"rviz", "rviz::ViewController"};
  std::vector<std::string> faults_;
  int classes_ = 0;
};

rviz::Config fromText(const std::string& text) {
  rviz::Config config;
  rviz::YamlConfigReader reader;
  reader.readString(config, QString::fromStdString(text));
  EXPECT_FALSE(reader.error()) << reader.errorMessage().toStdString();
  return config;
}

TEST(RvizConfigurations, haveNoUnknownClasses) {
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(SCAN_TO_PATH_SOURCE_DIR "/rviz")) {
    if (file.path().extension() != ".rviz") continue;
    ++files;
    rviz::Config config;
    rviz::YamlConfigReader reader;
    reader.readFile(config, QString::fromStdString(file.path().string()));
    ASSERT_FALSE(reader.error()) << reader.errorMessage().toStdString();
    Checker checker;
    EXPECT_THAT(checker.check(config), testing::IsEmpty()) << file.path();
    EXPECT_GE(checker.classes(), 2) << file.path();  // a display and a view at least
  }
  EXPECT_GE(files, 1);
}

TEST(RvizConfigurations, unknownClassesAndSettingsAreFound) {
  const auto config = fromText(
      "Panels:\n"
      "  - Class: scan_to_path/NoSuchPanel\n"
      "Visualization Manager:\n"
      "  Displays:\n"
      "    - Class: rviz/Group\n"
      "      Displays:\n"
      "        - Class: scan_to_path/NoSuchDisplay\n"
      "        - {Class: scan_to_path/ToolPath, Line Widht: 1}\n"
      "  Views:\n"
      "    Current: {Class: rviz/Orbit}\n");
  using testing::HasSubstr;
  EXPECT_THAT(Checker().check(config), testing::ElementsAre(HasSubstr("NoSuchPanel"), HasSubstr("NoSuchDisplay"),
                                                            HasSubstr("no setting Line Widht")));
}

}  // namespace
