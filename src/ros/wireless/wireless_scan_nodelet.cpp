#include "ros/wireless/wireless_scan_nodelet.h"

#include <ros/ros.h>
#include <structure_from_wifi/WifiScan.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "ros/conversion/parameters.h"

namespace sfw {

WirelessScanNodelet::~WirelessScanNodelet() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void WirelessScanNodelet::onInit() {
  try {
    settings_ = wirelessSettingsFromYaml(parametersOf(getPrivateNodeHandle()));
    for (const std::string& warning : settings_.warnings) {
      NODELET_WARN_STREAM(warning);
    }
    constexpr std::uint32_t kQueue = 100;
    publisher_ = getNodeHandle().advertise<structure_from_wifi::WifiScan>("wifi_scan", kQueue);
    diagnostics_.emplace(getNodeHandle(), getPrivateNodeHandle(), getName());
    diagnostics_->add("radio", [this](auto& status) { describe(status); });
    thread_ = std::thread([this] { run(); });
  } catch (const std::exception& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("The radio cannot be read: " << problem);
    }
  }
}

void WirelessScanNodelet::run() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds kDiagnosticsPeriod{1};
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(1.0 / settings_.rate_hz));
  WirelessReader reader({wirelessMode(settings_.mode), settings_.interface}, stop_);
  Clock::time_point next = Clock::now();
  Clock::time_point next_diagnostics = next;
  while (!stop_) {
    bool has_failed = true;
    try {
      const RadioReport report = reader.look();
      if (stop_) {
        return;
      }
      interface_ = report.interface;
      problem_ = report.problem;
      announce(report);
      publish(report);
      if (Clock::now() >= next_diagnostics) {
        diagnostics_->setHardwareID(interface_.empty() ? "none" : interface_);
        diagnostics_->force_update();  // update() would stop with the simulated clock
        next_diagnostics = Clock::now() + kDiagnosticsPeriod;
      }
      has_failed = !report.problem.empty();
    } catch (const std::exception&) {
      // Memory ran out, also for a text. An exception that leaves the thread ends the process.
    }
    // After a failure it waits a second, so that nobody is flooded.
    next = std::max(next + period, Clock::now());
    const Clock::time_point wake =
        has_failed ? std::max(next, Clock::now() + kDiagnosticsPeriod) : next;
    std::unique_lock<std::mutex> lock(mutex_);
    wake_.wait_until(lock, wake, [this] { return stop_.load(); });
  }
}

void WirelessScanNodelet::publish(const RadioReport& report) {
  if (report.readings.empty()) {
    return;
  }
  structure_from_wifi::WifiScan scan;
  scan.header.stamp = ros::Time::now();
  scan.header.frame_id = settings_.frame_id;
  for (const RadioReading& one : report.readings) {
    structure_from_wifi::ApReading reading;
    reading.bssid = one.bssid.str();
    reading.ssid = one.ssid;
    reading.rssi_dbm = static_cast<float>(one.rssi_dbm);
    reading.frequency_mhz = static_cast<float>(one.frequency_mhz);
    reading.age_s = static_cast<float>(one.age_s);
    scan.readings.push_back(reading);
  }
  publisher_.publish(scan);
  ++scans_;
  readings_ += scan.readings.size();
}

void WirelessScanNodelet::announce(const RadioReport& report) {
  if (announced_ == report.problem) {
    return;
  }
  announced_ = report.problem;
  if (report.problem.empty()) {
    NODELET_INFO_STREAM("The radio '" << report.interface << "' is read in mode " << settings_.mode
                                      << ".");
  } else {
    NODELET_WARN_STREAM(report.problem);
  }
}

void WirelessScanNodelet::describe(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  if (!problem_.empty()) {
    status.summary(interface_.empty() ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN, problem_);
  } else {
    status.summary(DiagnosticStatus::OK, "The radio is read.");
  }
  status.add("interface", interface_);
  status.add("mode", settings_.mode);
  status.add("scans", scans_);
  status.add("readings", readings_);
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::WirelessScanNodelet, nodelet::Nodelet)
