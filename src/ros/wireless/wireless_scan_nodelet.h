#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <nodelet/nodelet.h>
#include <ros/publisher.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "ros/wireless/wireless_settings.h"

namespace sfw {

/// Publishes the signal strengths that the machine's own radio hears on `wifi_scan`.
///
/// A thread of the nodelet looks at the radio, since a scan takes seconds. What is wrong with the
/// radio goes to the log when it changes, and to /diagnostics once a second. The nodelet never
/// gives up: an adapter may be plugged in later. If a parameter cannot be used, the nodelet logs an
/// error and advertises nothing.
class WirelessScanNodelet : public nodelet::Nodelet {
 public:
  ~WirelessScanNodelet() override;

 private:
  void onInit() override;
  void run();
  void publish(const RadioReport& report);
  /// Logs the state of the radio if it changed.
  void announce(const RadioReport& report);
  void describe(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  WirelessSettings settings_;
  ros::Publisher publisher_;
  std::optional<diagnostic_updater::Updater> diagnostics_;

  // Only the thread uses these.
  std::optional<std::string> announced_;
  std::string interface_;
  std::string problem_;
  std::uint64_t scans_ = 0;
  std::uint64_t readings_ = 0;

  std::mutex mutex_;
  std::condition_variable wake_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace sfw
