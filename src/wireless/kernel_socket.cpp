#include <netlink/errno.h>
#include <netlink/netlink.h>
#include <netlink/socket.h>
#include <poll.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "wireless/netlink_socket.h"

namespace sfw {
namespace {

struct FreeSocket {
  void operator()(nl_sock* socket) const { nl_socket_free(socket); }
};

/// The libnl error numbers are not those of errno.h.
[[noreturn]] void throwLibnlError(const char* what, int error) {
  throw WirelessError(0, std::string(what) + ": " + nl_geterror(error));
}

class KernelSocket : public NetlinkSocket {
 public:
  KernelSocket() : socket_(nl_socket_alloc()) {
    if (!socket_) {
      throw WirelessError(ENOMEM, "a netlink socket could not be made");
    }
    const int error = nl_connect(socket_.get(), NETLINK_GENERIC);
    if (error < 0) {
      throwLibnlError("the kernel's generic netlink could not be reached", error);
    }
    // A dump with many access points must fit the buffer of the socket.
    constexpr int kReceiveBuffer = 1 << 20;
    nl_socket_set_buffer_size(socket_.get(), kReceiveBuffer, 0);
    nl_socket_set_nonblocking(socket_.get());
  }

  void send(const Bytes& message) override {
    Bytes copy = message;  // libnl takes no constant bytes
    const int sent = nl_sendto(socket_.get(), copy.data(), copy.size());
    if (sent < 0) {
      throwLibnlError("a netlink message could not be sent", sent);
    }
  }

  Bytes receive(std::chrono::milliseconds timeout) override {
    pollfd readable{nl_socket_get_fd(socket_.get()), POLLIN, 0};
    if (poll(&readable, 1, static_cast<int>(timeout.count())) <= 0) {
      return {};
    }
    sockaddr_nl sender{};
    unsigned char* buffer = nullptr;
    const int size = nl_recv(socket_.get(), &sender, &buffer, nullptr);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owner(buffer, &std::free);
    if (size < 0) {
      throwLibnlError("netlink messages could not be received", size);
    }
    // Other programs may send to this socket, too.
    if (size == 0 || sender.nl_pid != 0) {
      return {};
    }
    return Bytes(buffer, buffer + size);
  }

  void join(std::uint32_t group) override {
    const int error = nl_socket_add_membership(socket_.get(), static_cast<int>(group));
    if (error < 0) {
      throwLibnlError("the kernel's events of scans could not be subscribed to", error);
    }
  }

 private:
  std::unique_ptr<nl_sock, FreeSocket> socket_;
};

}  // namespace

std::unique_ptr<NetlinkSocket> openKernelSocket() { return std::make_unique<KernelSocket>(); }

}  // namespace sfw
