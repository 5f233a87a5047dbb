#include "wireless/wireless_reader.h"

#include <time.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace sfw {
namespace {

/// Two times of hearing that differ by less are the same, since drivers round them.
constexpr double kRoundingS = 0.02;

double bootTime() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What went wrong, and what to do.
std::string explained(const WirelessError& error, const std::string& interface) {
  const std::string who = interface.empty() ? "the WiFi adapter" : "'" + interface + "'";
  switch (error.code()) {
    case ENOENT:
      return "The kernel has no nl80211, so no WiFi driver is loaded: load the driver of the "
             "adapter.";
    case EPERM:
    case EACCES:
      return "The kernel does not permit scans on " + who +
             ": give the program CAP_NET_ADMIN, run it as root, or use mode: cache.";
    case ENODEV:
      return "The interface " + who + " is gone: plug the adapter in again.";
    case ENETDOWN:
      return "The interface " + who + " is down: ip link set " +
             (interface.empty() ? "NAME" : interface) + " up.";
    case ERFKILL:
      return "The radio of " + who + " is switched off: rfkill unblock wifi.";
    case EOPNOTSUPP:
      return "The driver of " + who + " does not support this mode: use mode: link or cache.";
    default:
      return "The kernel refuses to tell about " + who + ": " + error.what() +
             ". The next look tries again.";
  }
}

double heardAt(const HeardNetwork& network, double now_s) {
  return network.heard_boot_s.value_or(now_s - network.age_s);
}

/// The signal of the station on the link of a network. With several links, that of the station may
/// be of any of them.
std::optional<double> signalOfLink(const LinkedStation& station, const HeardNetwork& network) {
  if (!network.multi_link) {
    return station.rssi_dbm;
  }
  for (const LinkedStation::Link& link : station.links) {
    if (link.id == network.link_id) {
      return link.rssi_dbm;
    }
  }
  return std::nullopt;
}

std::string namesOf(const std::vector<WirelessInterface>& interfaces) {
  std::string names;
  for (const WirelessInterface& one : interfaces) {
    names += (names.empty() ? "" : ", ") + one.name;
  }
  return names;
}

}  // namespace

WirelessReader::WirelessReader(Config config, const std::atomic<bool>& stop, OpenSocket open_socket)
    : WirelessReader(std::move(config), stop, std::move(open_socket), bootTime) {}

WirelessReader::WirelessReader(Config config, const std::atomic<bool>& stop, OpenSocket open_socket,
                               BootClock boot_clock)
    : config_(std::move(config)),
      stop_(stop),
      open_socket_(std::move(open_socket)),
      boot_clock_(std::move(boot_clock)) {}

RadioReport WirelessReader::look() {
  RadioReport report;
  try {
    if (!kernel_) {
      kernel_ = std::make_unique<Nl80211>(open_socket_(), stop_);
    }
    lookAt(report);
  } catch (const WirelessError& error) {
    report.problem = explained(error, report.interface);
    kernel_.reset();  // answers of the failed question may still come
  }
  return report;
}

void WirelessReader::lookAt(RadioReport& report) {
  const auto interface = choose(report);
  if (!interface) {
    return;
  }
  report.interface = interface->name;
  if (config_.mode == WirelessMode::kScan) {
    scan(interface->index, report);
  }
  const std::vector<HeardNetwork> networks = kernel_->networks(interface->index);
  addLink(networks, interface->index, report);
  std::size_t without_dbm = 0;
  const double now_s = boot_clock_();
  for (const HeardNetwork& network : networks) {
    without_dbm += network.rssi_dbm ? 0 : 1;
    if (network.rssi_dbm && config_.mode != WirelessMode::kLink) {
      add(network, *network.rssi_dbm, heardAt(network, now_s), report);
    }
  }
  if (!report.problem.empty()) {
    return;
  }
  if (!networks.empty() && without_dbm == networks.size()) {
    report.problem =
        "The driver of '" + interface->name +
        "' gives signal strengths without unit, and dBm are needed: use another adapter.";
  } else if (config_.mode == WirelessMode::kCache && networks.empty()) {
    report.problem = "The kernel's cache of '" + interface->name +
                     "' is empty, since no program scans: use mode: scan.";
  }
}

std::optional<WirelessInterface> WirelessReader::choose(RadioReport& report) {
  const std::vector<WirelessInterface> interfaces = kernel_->interfaces();
  const auto chosen =
      std::find_if(interfaces.begin(), interfaces.end(), [&](const WirelessInterface& one) {
        return config_.interface.empty() ? one.is_station : one.name == config_.interface;
      });
  if (chosen != interfaces.end()) {
    return *chosen;
  }
  if (interfaces.empty()) {
    report.problem =
        "No WiFi adapter is found: plug one in, and look whether its driver is loaded.";
  } else if (config_.interface.empty()) {
    report.problem = "No WiFi adapter is a client of access points (" + namesOf(interfaces) +
                     "): name one with interface.";
  } else {
    report.problem = "The interface '" + config_.interface +
                     "' is no WiFi adapter of this machine (" + namesOf(interfaces) +
                     "): correct interface, or plug it in again.";
  }
  return std::nullopt;
}

void WirelessReader::scan(std::uint32_t interface, RadioReport& report) {
  constexpr std::chrono::seconds kLongestScan{15};  // of passive channels of three bands
  try {
    kernel_->startScan(interface);
  } catch (const WirelessError& error) {
    if (error.code() != EBUSY) {  // another program's scan serves as well
      report.problem = explained(error, report.interface);
      return;  // the cache still tells something
    }
  }
  switch (kernel_->awaitScan(interface, kLongestScan)) {
    case Nl80211::ScanEnd::kDone:
      return;
    case Nl80211::ScanEnd::kAborted:
      report.problem = "The scan on '" + report.interface +
                       "' was aborted by the driver: it scans again at the next look.";
      return;
    case Nl80211::ScanEnd::kTimeout:
      if (!stop_) {
        report.problem = "The scan on '" + report.interface +
                         "' did not end: look at the kernel's log of the driver.";
      }
  }
}

void WirelessReader::addLink(const std::vector<HeardNetwork>& networks, std::uint32_t interface,
                             RadioReport& report) {
  const double now_s = boot_clock_();
  const std::vector<LinkedStation> stations = kernel_->stations(interface);
  bool is_associated = false;
  for (const HeardNetwork& network : networks) {
    if (!network.is_associated) {
      continue;
    }
    is_associated = true;
    const Bssid address = network.multi_link.value_or(network.bssid);
    const auto station =
        std::find_if(stations.begin(), stations.end(),
                     [&](const LinkedStation& one) { return one.address == address; });
    if (station == stations.end()) {
      continue;
    }
    const std::optional<double> rssi_dbm = signalOfLink(*station, network);
    if (rssi_dbm) {
      add(network, *rssi_dbm, now_s - station->inactive_s, report);
    } else if (network.rssi_dbm && config_.mode == WirelessMode::kLink) {
      add(network, *network.rssi_dbm, heardAt(network, now_s), report);
    }
  }
  if (!is_associated && config_.mode == WirelessMode::kLink) {
    report.problem =
        "'" + report.interface +
        "' is associated with no access point: connect it, or use mode: cache or scan.";
  }
}

void WirelessReader::add(const HeardNetwork& network, double rssi_dbm, double heard_boot_s,
                         RadioReport& report) {
  const double now_s = boot_clock_();
  const auto told = told_.find(network.bssid);
  if (told != told_.end() && heard_boot_s < told->second + kRoundingS) {
    return;
  }
  constexpr std::size_t kMostTold = 10000;  // phones change their addresses all the time
  if (told_.size() >= kMostTold) {
    told_.clear();
  }
  told_[network.bssid] = heard_boot_s;
  report.readings.push_back({network.bssid, network.ssid, rssi_dbm, network.frequency_mhz,
                             std::max(now_s - heard_boot_s, 0.0)});
}

}  // namespace sfw
