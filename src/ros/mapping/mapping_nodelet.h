#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <geometry_msgs/PointStamped.h>
#include <nav_msgs/GetMap.h>
#include <nodelet/nodelet.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <structure_from_wifi/ClearRegion.h>
#include <structure_from_wifi/LoadMap.h>
#include <structure_from_wifi/SaveMap.h>
#include <tf2_ros/buffer.h>
#include <topic_tools/shape_shifter.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ros/conversion/input_messages.h"
#include "ros/conversion/live_settings.h"
#include "ros/conversion/ros_settings.h"
#include "ros/mapping/announcements.h"
#include "ros/mapping/diagnostics.h"
#include "ros/mapping/floors.h"
#include "ros/mapping/input_statistics.h"
#include "ros/mapping/map_publishers.h"
#include "ros/mapping/observation_queue.h"
#include "ros/mapping/pose_watch.h"
#include "ros/mapping/refresh_rule.h"
#include "ros/mapping/robots.h"
#include "ros/mapping/scan_localisation.h"
#include "ros/mapping/shared_mapper.h"
#include "ros/mapping/transform_intake.h"
#include "ros/mapping/transform_watch.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Makes maps while the robot drives, from scans and tf.
///
/// Input callbacks only fill a queue. The locating thread empties the queue as tf allows and
/// answers quick service calls. The mapping thread infers maps from copies, publishes them and
/// answers slow service calls. So no callback of the nodelet manager waits for either thread, and
/// readings are located while a map is inferred. Topics, services and parameters:
/// doc/interfaces.md.
class MappingNodelet : public nodelet::Nodelet {
 public:
  ~MappingNodelet() override;

 private:
  /// Never throws, since an exception would end the nodelet manager. If parameters cannot be used,
  /// or memory runs out, the nodelet logs why and advertises nothing but its diagnostics.
  void onInit() override;
  void start();
  /// Takes back what start() did, and logs each problem.
  void giveUp(const std::exception& error) noexcept;
  void advertiseDiagnostics();
  void announceStart();

  /// @throw InputError naming each parameter that cannot be used, or why they make no map
  void loadParameters();
  void readParameters();
  void advertise();
  void warnOfOtherMappers();
  void advertiseServices();
  void advertiseLiveSettings();
  void subscribe();

  /// Where messages come from.
  struct Source {
    const Input* input = nullptr;
    std::string topic;
    std::string antenna_frame;  ///< of the robot that has the topic; empty: that of several robots
    std::size_t index = 0;      ///< in statistics_
  };
  struct Subscription {
    Source source;
    ros::Subscriber subscriber;
    bool was_connected = false;  ///< at the last look, as the next member
    std::size_t messages = 0;
  };
  /// All inputs; of several robots, also those in the namespace of each one.
  std::vector<Source> sources() const;
  void subscribeTo(Subscription& to);

  // In the manager's threads.
  void receive(const Source& source, const topic_tools::ShapeShifter& message);
  void convert(const Source& source, const AnyMessage& message);
  void warnOfProblem(const std::string& topic, const std::string& problem);
  void noteFailedMessage(const Source& source, const std::exception& error) noexcept;

  struct Step {
    void (MappingNodelet::*take)();
    const char* failure;  ///< what is logged with its reason
  };
  static const std::vector<Step> kLocatingSteps, kMappingSteps;
  /// Answers the service calls in a queue, with steps in between, until the nodelet ends. A step
  /// that fails keeps no other one from its work.
  void run(ros::CallbackQueue& calls, const std::vector<Step>& steps);
  void noteFailure(const char* what, const std::exception& error) noexcept;

  // In the locating thread.
  void takeInReadings();
  /// Publishes diagnostics and warns of missing inputs, once a second.
  void diagnose();
  void announceMissingInput();
  /// Subscribes again where the last publisher went: roscpp keeps its type, and refuses others.
  void subscribeAnew();
  MappingStatus status() const;
  /// The transform of the first robot that lacks it, or else of the first robot.
  TransformStatus transformStatusOfRobots() const;
  FrameFinding frameFindingOfRobots() const;
  void noticeTimeJump(const ros::Time& now);
  bool serveMap(nav_msgs::GetMap::Response& response);
  bool reset(std_srvs::Trigger::Response& response);
  /// Forgets everything but the geometry, and publishes the empty map. If that fails, the mapping
  /// thread publishes it.
  /// @return false if the nodelet stops
  bool startAnew();
  bool pause(const std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  // In the mapping thread.
  void publishWhatIsDue();
  void updateMap();
  /// Whether a localisation has moved a robot since the last map.
  bool hasJumped(const std::vector<OdometryCorrection>& latest) const;
  /// A map, its data, and the results of its checks.
  struct Mapping {
    SharedMapper::Copy copy;
    std::shared_ptr<const Snapshot> snapshot;  ///< nullptr if the nodelet stops
    DataFindings findings;
  };
  enum class Checks { kChanged, kAll };
  /// Makes a map, checks its data, and publishes both unless a reset occurred meanwhile. If it
  /// throws, the map is due as before.
  Mapping publishMap(Checks checks);
  Mapping makeMap(Checks checks);
  /// Whether something is new, or a kept part of the last map is out of date.
  bool isUpdateDue();
  /// The map of a copy, with parts of the last one.
  std::shared_ptr<const Snapshot> refreshed(const SharedMapper::Copy& copy, bool has_jumped);
  void noteUpdate(double inference_s);
  /// Logs each fault once, until the next reset.
  void reportFaults(const std::vector<MapNote>& notes);
  bool serveOctomap(bool binary, octomap_msgs::GetOctomap::Response& response);
  bool saveMap(const structure_from_wifi::SaveMap::Request& request,
               structure_from_wifi::SaveMap::Response& response);
  bool loadMap(const structure_from_wifi::LoadMap::Request& request,
               structure_from_wifi::LoadMap::Response& response);
  bool clearRegion(const structure_from_wifi::ClearRegion::Request& request,
                   structure_from_wifi::ClearRegion::Response& response);
  /// Gives the access point `~clicked_point_bssid` the position of a click in rviz.
  void placeAccessPoint(const geometry_msgs::PointStamped& click);
  void refreshWhollyAnew();

  // Settings that dynamic_reconfigure changes, in the mapping thread.
  /// Takes over the settings, or tells why not and gives back the present ones.
  void changeSettings(structure_from_wifi::LiveConfig& live);
  void takeSettings(const structure_from_wifi::LiveConfig& live, const MappingSettings& wanted);

  // Sessions, in the mapping thread; the destructor saves the last time.
  void resumeOnce();
  /// @return what was added, in words
  std::string addSession(const std::string& directory);
  void autosaveIfDue();
  /// Never throws; a failure is logged and shown in diagnostics.
  void autosave();
  std::string autosaveDirectory() const;

  std::string whyNothingToSave() const;
  /// The directory of a name. It gets a number if it holds a recording that this session did not
  /// write.
  std::string directoryToSave(const std::string& name);
  void forgetDirectories();

  // In both threads.
  void locateObservations();
  /// @return whether the observation asks for another map
  bool insert(const LocatedObservation& observation);
  /// Tells of tilts and jumps; locating_ is held.
  void notePoses(std::size_t jumped);
  void announceFirstReading(const LocatedObservation& observation);
  void warnOfLosses(const ObservationQueue::Outcome& outcome);
  void warnOfRejections();
  void announceMap(const PublishedMap& map);

  Config config_;
  RosSettings ros_settings_;
  ScanSettings scan_settings_;
  std::vector<AccessPoint> access_points_;
  std::optional<SharedMapper> mapper_;
  std::optional<ObservationQueue> queue_;
  std::optional<Robots> robots_;  // never changes after onInit
  std::optional<MapPublishers> publishers_;

  std::optional<tf2_ros::Buffer> transforms_;
  std::optional<ScanLocalisation> localisation_;  // none: it is switched off
  TransformWatch transform_watch_;
  std::optional<TransformIntake> transform_intake_;
  Floors floors_;
  std::mutex subscribing_;                   // around the next member
  std::vector<Subscription> subscriptions_;  // to the inputs

  ros::CallbackQueue quick_calls_, slow_calls_;  // outlive the servers that use them
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber click_subscriber_;
  std::unique_ptr<dynamic_reconfigure::Server<structure_from_wifi::LiveConfig>> live_server_;

  std::mutex locating_;    // held while observations go from the queue to the mapper
  std::mutex publishing_;  // held while a map is published, and during a reset
  ros::Time last_now_;
  ros::SteadyTime last_update_;     // its start; in the mapping thread only, as the next members
  double last_update_cpu_s_ = 0.0;  // CPU time that it took
  RefreshCache refresh_cache_;
  std::uint64_t refresh_resets_ = 0;  // of the mapper when the cache was filled
  std::int64_t updates_without_news_ = 0;
  DataChecker checker_;
  std::set<std::pair<MapNote::Kind, std::string>> reported_faults_;  // since the last reset
  std::atomic<bool> clear_reported_{false};
  std::set<std::string> own_directories_;  // written since the last reset; in the mapping thread
  std::atomic<bool> forget_directories_{false};
  bool resumed_ = false;  // in the mapping thread, as the next member
  ros::SteadyTime next_autosave_;
  std::atomic<bool> unsaved_{false};  // since the last autosave
  std::atomic<bool> paused_{false};
  std::optional<RefreshRule> refresh_rule_;  // guarded by locating_, as the next member
  std::optional<PoseWatch> pose_watch_;

  // Facts for diagnostics and logs.
  std::optional<diagnostic_updater::Updater> diagnostics_;
  MappingStatus status_;  // of the last diagnose()
  ros::SteadyTime started_, next_diagnosis_;
  InputStatistics statistics_;
  Announcements announcements_;
  std::string failure_;             // why the nodelet cannot map; never changes after onInit
  mutable std::mutex facts_mutex_;  // around the next member
  struct Facts {
    std::string update_failure;
    std::string autosave_failure;
    double inference_s = 0.0;
    std::size_t expired = 0, expired_contacts = 0, overflowed = 0, tilted = 0, jumped = 0;
  } facts_;

  std::vector<OdometryCorrection> last_map_corrections_;  // tf's at the last map
  std::atomic<bool> changed_{false};                      // since the last map
  std::atomic<bool> stop_{false};
  std::thread locating_thread_, mapping_thread_;
};

}  // namespace sfw
