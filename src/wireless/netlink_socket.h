#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace sfw {

using Bytes = std::vector<std::uint8_t>;

/// What the kernel refused, with its error number (errno.h); 0 if it gave none.
class WirelessError : public std::runtime_error {
 public:
  WirelessError(int code, const std::string& what) : std::runtime_error(what), code_(code) {}
  int code() const { return code_; }

 private:
  int code_;
};

/// A socket to the kernel's generic netlink. Everything above it works on the bytes of messages, so
/// a simulated kernel can stand below.
class NetlinkSocket {
 public:
  virtual ~NetlinkSocket() = default;

  /// Sends one message, with its header.
  /// @throw WirelessError
  virtual void send(const Bytes& message) = 0;

  /// Receives one datagram, which may hold several messages. Empty if none comes in time.
  /// @throw WirelessError
  virtual Bytes receive(std::chrono::milliseconds timeout) = 0;

  /// Subscribes to the events of a multicast group.
  /// @throw WirelessError
  virtual void join(std::uint32_t group) = 0;
};

/// Opens a socket of the running kernel.
/// @throw WirelessError
std::unique_ptr<NetlinkSocket> openKernelSocket();

}  // namespace sfw
