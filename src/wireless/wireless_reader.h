#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/bssid.h"
#include "wireless/nl80211.h"

namespace sfw {

/// Which signals a robot's own radio tells.
enum class WirelessMode {
  kLink,   ///< of the access point that it is associated with
  kCache,  ///< also of those that the kernel heard in scans of other programs
  kScan,   ///< of all access points: it scans, which needs the capability CAP_NET_ADMIN
};

/// A signal strength, and how long ago it was heard.
struct RadioReading {
  Bssid bssid;
  std::string ssid;  ///< any bytes
  double rssi_dbm = 0.0;
  double frequency_mhz = 0.0;  ///< 0 if unknown
  double age_s = 0.0;
};

/// The result of one look at the radio.
struct RadioReport {
  std::string interface;  ///< empty if there is none
  std::vector<RadioReading> readings;
  std::string problem;  ///< what is wrong and what to do, a sentence; empty if all is well
};

/// Reads the machine's own radio through nl80211. It never gives up: each look may find what the
/// last one missed. Not thread-safe.
class WirelessReader {
 public:
  struct Config {
    WirelessMode mode = WirelessMode::kCache;
    std::string interface;  ///< empty: the first one that is a client of access points
  };
  using OpenSocket = std::function<std::unique_ptr<NetlinkSocket>()>;
  /// The time since the boot of the machine [s].
  using BootClock = std::function<double()>;

  /// @param stop  ends a look early when it turns true; outlives the reader
  WirelessReader(Config config, const std::atomic<bool>& stop,
                 OpenSocket open_socket = openKernelSocket);
  WirelessReader(Config config, const std::atomic<bool>& stop, OpenSocket open_socket,
                 BootClock boot_clock);

  /// Looks once. A value that was told before is not told again. Never throws.
  RadioReport look();

 private:
  void lookAt(RadioReport& report);
  std::optional<WirelessInterface> choose(RadioReport& report);
  void scan(std::uint32_t interface, RadioReport& report);
  /// Adds the signal of the link from the station at its other end.
  void addLink(const std::vector<HeardNetwork>& networks, std::uint32_t interface,
               RadioReport& report);
  /// Adds a reading, unless its value was told before.
  void add(const HeardNetwork& network, double rssi_dbm, double heard_boot_s, RadioReport& report);

  Config config_;
  const std::atomic<bool>& stop_;
  OpenSocket open_socket_;
  BootClock boot_clock_;
  std::unique_ptr<Nl80211> kernel_;
  std::map<Bssid, double> told_;  ///< when the last value of each radio was heard [s]
};

}  // namespace sfw
