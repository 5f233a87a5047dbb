#pragma once

#include <arpa/inet.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace sfw {

/// Subscribes to a topic of this process over TCP, and never reads a byte of what comes: the
/// slowest subscriber that there can be.
class StuckSubscriber {
 public:
  /// @throw std::runtime_error if the topic cannot be subscribed to
  template <class Message>
  static int connect(const std::string& topic) {
    return connect(topic, ros::message_traits::datatype<Message>(),
                   ros::message_traits::md5sum<Message>());
  }

  /// @return the socket, to be closed
  static int connect(const std::string& topic, const std::string& type, const std::string& md5) {
    std::string host;
    std::uint32_t port = 0;
    ros::network::splitURI(ros::XMLRPCManager::instance()->getServerURI(), host, port);
    XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
    XmlRpc::XmlRpcValue request, response;
    request[0] = "/stuck";
    request[1] = topic;
    request[2][0][0] = "TCPROS";
    if (!client.execute("requestTopic", request, response) || static_cast<int>(response[0]) != 1) {
      throw std::runtime_error("requestTopic failed");
    }
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(static_cast<int>(response[2][2])));
    inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
    const std::string header = headerOf(
        {"callerid=/stuck", "topic=" + topic, "type=" + type, "md5sum=" + md5, "tcp_nodelay=1"});
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        write(socket, header.data(), header.size()) != static_cast<ssize_t>(header.size())) {
      close(socket);
      throw std::runtime_error("the topic's server cannot be reached");
    }
    return socket;
  }

 private:
  static std::string sized(const std::string& bytes) {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    return std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes;
  }

  static std::string headerOf(const std::vector<std::string>& fields) {
    std::string header;
    for (const std::string& field : fields) {
      header += sized(field);
    }
    return sized(header);
  }
};

}  // namespace sfw
