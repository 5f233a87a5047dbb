#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/bssid.h"
#include "wireless/netlink_socket.h"

namespace sfw {

/// The messages of the kernel's nl80211, as bytes. The parsers take bytes from anywhere: what is
/// malformed is left out, and nothing beyond the end is read.

/// The number that the kernel gave to nl80211, and to its events of scans.
struct Nl80211Family {
  std::uint16_t id = 0;
  std::optional<std::uint32_t> scan_group;
};

struct WirelessInterface {
  std::uint32_t index = 0;
  std::string name;
  bool is_station = false;  ///< a client of access points, not an access point or a monitor
};

/// A network that the kernel heard. With Wi-Fi 7 each link of an access point is one.
struct HeardNetwork {
  Bssid bssid;                          ///< of the link, never the multi-link address
  std::optional<Bssid> multi_link;      ///< the address of the access point with several links
  std::optional<std::uint8_t> link_id;  ///< of the link, with several links
  std::string ssid;                     ///< any bytes
  double frequency_mhz = 0.0;
  std::optional<double> rssi_dbm;      ///< nothing if the driver gives no dBm
  std::optional<double> heard_boot_s;  ///< when, by the clock CLOCK_BOOTTIME
  double age_s = 0.0;                  ///< how long ago, if heard_boot_s is nothing
  bool is_associated = false;
};

/// The access point at the other end of the link.
struct LinkedStation {
  struct Link {
    std::uint8_t id = 0;
    std::optional<double> rssi_dbm;
  };
  Bssid address;  ///< its BSSID, or its multi-link address
  std::optional<double> rssi_dbm;
  double inactive_s = 0.0;  ///< since its last frame
  std::vector<Link> links;  ///< with several links, if the kernel tells them
};

/// Requests. @{
Bytes familyRequest(std::uint32_t sequence);
Bytes interfacesRequest(const Nl80211Family& family, std::uint32_t sequence);
Bytes networksRequest(const Nl80211Family& family, std::uint32_t interface, std::uint32_t sequence);
Bytes stationsRequest(const Nl80211Family& family, std::uint32_t interface, std::uint32_t sequence);
Bytes scanRequest(const Nl80211Family& family, std::uint32_t interface, std::uint32_t sequence);
/// @}

/// Answers; nothing if the message is no such answer. @{
std::optional<Nl80211Family> parseFamily(const Bytes& message);
std::optional<WirelessInterface> parseInterface(const Bytes& message);
std::optional<HeardNetwork> parseNetwork(const Bytes& message);
std::optional<LinkedStation> parseStation(const Bytes& message);
/// @}

/// The end of a scan.
struct ScanEvent {
  std::uint32_t interface = 0;
  bool is_aborted = false;
};
std::optional<ScanEvent> parseScanEvent(const Bytes& message);

/// Splits a datagram into its messages. A message that reaches beyond the end is left out.
std::vector<Bytes> splitMessages(const Bytes& datagram);

/// The header of a message.
struct MessageHeader {
  std::uint16_t type = 0;
  std::uint32_t sequence = 0;
  bool is_last = false;      ///< ends a dump
  std::optional<int> error;  ///< of errno.h; 0 acknowledges
};
std::optional<MessageHeader> parseHeader(const Bytes& message);

}  // namespace sfw
