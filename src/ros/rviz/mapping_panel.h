#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <rviz/panel.h>

#include <future>
#include <string>

#include "ros/rviz/mapper_status.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace sfw {

/// A panel of rviz that shows why there is a map or none, and saves, resets and pauses the mapper.
///
/// It listens to `/diagnostics` and calls the services of the node that the user chose. All members
/// run in rviz's main thread; service calls run in a thread of their own, one at a time.
class MappingPanel : public rviz::Panel {
 public:
  explicit MappingPanel(QWidget* parent = nullptr);
  /// Waits for a service call that is under way.
  ~MappingPanel() override;

  void load(const rviz::Config& config) override;
  void save(rviz::Config config) const override;

 private:
  void receive(const diagnostic_msgs::DiagnosticArray& diagnostics);
  /// Shows the present state, and the answer of a service call that has ended.
  void refresh();
  void showFigures();
  std::string node() const;
  std::string service(const std::string& name) const;
  /// Calls a service in the background; its answer is shown when it comes.
  template <class Service>
  void call(const std::string& name, const Service& request);
  void say(const std::string& text);

  ros::NodeHandle ros_;
  ros::Subscriber subscriber_;
  MapperStatus status_;
  std::future<std::string> answer_;  ///< of the service call under way
  std::string chosen_;               ///< node of the saved configuration, until it is heard

  QComboBox* nodes_ = nullptr;
  QLabel* reports_ = nullptr;
  QLabel* figures_ = nullptr;
  QLabel* message_ = nullptr;
  QLineEdit* directory_ = nullptr;
  QPushButton* save_ = nullptr;
  QPushButton* pause_ = nullptr;
  QPushButton* reset_ = nullptr;
};

}  // namespace sfw
