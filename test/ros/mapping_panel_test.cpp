#include "ros/rviz/mapping_panel.h"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <filesystem>
#include <string>

#include "mapping_launch_world.h"

namespace sfw::test {
namespace {

/// The panel beside a real mapping node, pressed as a user does.
class MappingPanelTest : public testing::Test {
 protected:
  std::string text(const char* label) const {
    return panel_.findChild<QLabel*>(label)->text().toStdString();
  }

  QPushButton& button(const char* name) const { return *panel_.findChild<QPushButton*>(name); }

  static bool becomes(const std::function<bool()>& done) {
    return LaunchWorld::spinUntil(
        [&] {
          QApplication::processEvents();
          return done();
        },
        30.0);
  }

  bool shows(const char* label, const std::string& words) const {
    return becomes([&] { return text(label).find(words) != std::string::npos; });
  }

  /// Presses a button as soon as it can be pressed.
  void press(const char* name) {
    ASSERT_TRUE(becomes([&] { return button(name).isEnabled(); })) << name;
    button(name).click();
  }

  /// Saves a picture of the panel for people, beside the result of the test.
  /// @return the share of its pixels that differ from its background
  double takeScreenshot() {
    panel_.show();
    panel_.resize(320, 420);  // as a dock of rviz
    QApplication::processEvents();
    const QImage image = panel_.grab().toImage();
    const std::string result = testing::GTEST_FLAG(output);  // xml:FILE.xml
    if (result.rfind("xml:", 0) == 0) {
      const std::filesystem::path file = std::filesystem::path(result.substr(4));
      image.save((file.parent_path() / "mapping_panel.png").c_str());
    }
    std::size_t drawn = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        drawn += image.pixel(x, y) != image.pixel(0, 0) ? 1 : 0;
      }
    }
    return static_cast<double>(drawn) / (image.width() * image.height());
  }

  MappingPanel panel_;
};

TEST_F(MappingPanelTest, ServesAUserFromTheFirstReadingToTheSavedMap) {
  EXPECT_TRUE(shows("Reports", "There is no map yet")) << text("Reports");

  press("Save");
  EXPECT_TRUE(shows("Message", "Not saved: ")) << text("Message");

  ASSERT_TRUE(LaunchWorld::drive());
  EXPECT_TRUE(shows("Figures", "<b>2</b>")) << text("Figures");  // access points
  EXPECT_TRUE(shows("Figures", "m2")) << text("Figures");        // free area
  EXPECT_GT(takeScreenshot(), 0.02);
  for (const char* name : {"Reports", "Figures", "Message"}) {
    const auto* label = panel_.findChild<QLabel*>(name);
    EXPECT_GE(label->height(), label->heightForWidth(label->width())) << name << " is cut";
  }

  press("Save");
  EXPECT_TRUE(shows("Message", "Saved: ")) << text("Message");
  EXPECT_TRUE(std::filesystem::exists(LaunchWorld::saveDirectory() / "map" / "map.yaml"));

  press("Pause");
  EXPECT_TRUE(shows("Reports", "paused")) << text("Reports");
  press("Pause");
  EXPECT_TRUE(becomes([&] { return text("Reports").find("paused") == std::string::npos; }));

  press("Reset");
  EXPECT_TRUE(shows("Figures", "<b>0</b>")) << text("Figures");
}

}  // namespace
}  // namespace sfw::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mapping_panel_test");
  const ros::NodeHandle keeps_ros_up;
  QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
