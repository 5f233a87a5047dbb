#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "wireless/netlink_socket.h"
#include "wireless/nl80211_messages.h"

namespace sfw {

/// Questions to the kernel's nl80211, and its answers.
///
/// Every call waits two seconds at most for an answer, and ends early when `stop` turns true.
class Nl80211 {
 public:
  /// @throw WirelessError with code ENOENT if the kernel has no nl80211
  Nl80211(std::unique_ptr<NetlinkSocket> socket, const std::atomic<bool>& stop);

  /// @throw WirelessError, as all functions below do
  std::vector<WirelessInterface> interfaces();

  /// What the kernel's cache of scans holds. Needs no privilege.
  std::vector<HeardNetwork> networks(std::uint32_t interface);

  std::vector<LinkedStation> stations(std::uint32_t interface);

  /// Starts a scan of all channels; EPERM without the capability CAP_NET_ADMIN.
  void startScan(std::uint32_t interface);

  enum class ScanEnd { kDone, kAborted, kTimeout };

  /// Waits for the end of a scan on this interface, whoever started it.
  ScanEnd awaitScan(std::uint32_t interface, std::chrono::milliseconds timeout);

 private:
  /// Sends a request and gives each message of the answer to `visit`.
  void ask(const Bytes& request, std::uint32_t sequence,
           const std::function<void(const Bytes&)>& visit);
  std::vector<Bytes> receive();

  std::unique_ptr<NetlinkSocket> socket_;
  const std::atomic<bool>& stop_;
  std::uint32_t sequence_ = 0;
  Nl80211Family family_;
  std::deque<ScanEvent> events_;  ///< that came during other answers
};

}  // namespace sfw
