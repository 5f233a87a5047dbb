#pragma once

#include <linux/nl80211.h>
#include <netlink/attr.h>
#include <netlink/genl/ctrl.h>
#include <netlink/genl/genl.h>
#include <netlink/msg.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wireless/netlink_socket.h"

namespace sfw::test {

using Address = std::array<std::uint8_t, 6>;

/// The state of a kernel with WiFi adapters, as a test wants it.
struct KernelState {
  struct Interface {
    std::uint32_t index = 3;
    std::string name = "wlan0";
    std::uint32_t type = NL80211_IFTYPE_STATION;
  };
  struct Network {
    Address bssid{};
    std::string ssid = "home";
    std::uint32_t frequency_mhz = 2437;
    std::int32_t signal_mbm = -5500;
    std::uint64_t heard_boot_ns = 0;
    std::uint32_t age_ms = 0;
    bool is_associated = false;
    bool has_unit = true;
    std::optional<Address> multi_link;
    std::uint8_t link_id = 0;
  };
  struct Station {
    Address address{};
    std::int8_t signal_dbm = -50;
    std::uint32_t inactive_ms = 0;
    std::map<std::uint8_t, std::int8_t> link_signals_dbm;
  };

  bool has_nl80211 = true;
  bool is_silent = false;
  std::vector<Interface> interfaces{{}};
  std::vector<Network> networks;
  std::vector<Station> stations;
  std::map<int, int> errors;                         ///< number of errno.h by command
  std::optional<int> after_scan;                     ///< command of the event that ends a scan
  std::function<void(KernelState&)> while_scanning;  ///< what a scan changes
};

/// Bytes of messages as the kernel sends them.
class KernelMessage {
 public:
  KernelMessage(std::uint16_t type, std::uint8_t command, std::uint32_t sequence, int flags = 0)
      : message_(nlmsg_alloc_size(kSize)) {
    genlmsg_put(message_.get(), 0, sequence, type, 0, flags, command, 1);
  }

  KernelMessage& u8(int type, std::uint8_t value) { return bytes(type, &value, sizeof value); }
  KernelMessage& u16(int type, std::uint16_t value) { return bytes(type, &value, sizeof value); }
  KernelMessage& u32(int type, std::uint32_t value) { return bytes(type, &value, sizeof value); }
  KernelMessage& u64(int type, std::uint64_t value) { return bytes(type, &value, sizeof value); }
  KernelMessage& address(int type, const Address& value) {
    return bytes(type, value.data(), value.size());
  }
  KernelMessage& text(int type, const std::string& value) {
    return bytes(type, value.c_str(), value.size() + 1);
  }
  KernelMessage& bytes(int type, const void* data, std::size_t size) {
    nla_put(message_.get(), type, static_cast<int>(size), data);
    return *this;
  }
  template <class Content>
  KernelMessage& nested(int type, Content&& content) {
    nlattr* attribute = nla_nest_start(message_.get(), type);
    content(*this);
    nla_nest_end(message_.get(), attribute);
    return *this;
  }

  Bytes take() const {
    const nlmsghdr* header = nlmsg_hdr(message_.get());
    const auto* begin = reinterpret_cast<const std::uint8_t*>(header);
    Bytes result(begin, begin + header->nlmsg_len);
    result.resize(NLMSG_ALIGN(result.size()));
    return result;
  }

 private:
  static constexpr std::size_t kSize = 8192;
  struct Free {
    void operator()(nl_msg* message) const { nlmsg_free(message); }
  };
  std::unique_ptr<nl_msg, Free> message_;
};

constexpr std::uint16_t kNl80211Id = 0x1c;
constexpr int kMloLinks = 312;  // as in Linux 6.0 and later
constexpr int kMloLinkId = 313;
constexpr int kBssLinkId = 21;
constexpr int kBssMultiLink = 22;

inline Bytes familyMessage(std::uint32_t sequence) {
  return KernelMessage(GENL_ID_CTRL, CTRL_CMD_NEWFAMILY, sequence)
      .u16(CTRL_ATTR_FAMILY_ID, kNl80211Id)
      .text(CTRL_ATTR_FAMILY_NAME, "nl80211")
      .nested(CTRL_ATTR_MCAST_GROUPS,
              [](KernelMessage& groups) {
                groups.nested(1, [](KernelMessage& group) {
                  group.u32(CTRL_ATTR_MCAST_GRP_ID, 5).text(CTRL_ATTR_MCAST_GRP_NAME, "config");
                });
                groups.nested(2, [](KernelMessage& group) {
                  group.u32(CTRL_ATTR_MCAST_GRP_ID, 6).text(CTRL_ATTR_MCAST_GRP_NAME, "scan");
                });
              })
      .take();
}

inline Bytes interfaceMessage(const KernelState::Interface& one, std::uint32_t sequence) {
  return KernelMessage(kNl80211Id, NL80211_CMD_NEW_INTERFACE, sequence, NLM_F_MULTI)
      .u32(NL80211_ATTR_IFINDEX, one.index)
      .text(NL80211_ATTR_IFNAME, one.name)
      .u32(NL80211_ATTR_IFTYPE, one.type)
      .take();
}

inline Bytes networkMessage(const KernelState::Network& one, std::uint32_t sequence) {
  std::string elements{1, 2, 3};  // an element of another kind comes first
  elements[1] = 1;
  elements += '\0';
  elements += static_cast<char>(one.ssid.size());
  elements += one.ssid;
  return KernelMessage(kNl80211Id, NL80211_CMD_NEW_SCAN_RESULTS, sequence, NLM_F_MULTI)
      .u32(NL80211_ATTR_IFINDEX, 3)
      .nested(NL80211_ATTR_BSS,
              [&](KernelMessage& bss) {
                bss.address(NL80211_BSS_BSSID, one.bssid)
                    .u32(NL80211_BSS_FREQUENCY, one.frequency_mhz)
                    .bytes(NL80211_BSS_INFORMATION_ELEMENTS, elements.data(), elements.size())
                    .u32(NL80211_BSS_SEEN_MS_AGO, one.age_ms);
                if (one.has_unit) {
                  bss.u32(NL80211_BSS_SIGNAL_MBM, static_cast<std::uint32_t>(one.signal_mbm));
                } else {
                  bss.u8(NL80211_BSS_SIGNAL_UNSPEC, 70);
                }
                if (one.heard_boot_ns != 0) {
                  bss.u64(NL80211_BSS_LAST_SEEN_BOOTTIME, one.heard_boot_ns);
                }
                if (one.is_associated) {
                  bss.u32(NL80211_BSS_STATUS, NL80211_BSS_STATUS_ASSOCIATED);
                }
                if (one.multi_link) {
                  bss.u8(kBssLinkId, one.link_id).address(kBssMultiLink, *one.multi_link);
                }
              })
      .take();
}

inline Bytes stationMessage(const KernelState::Station& one, std::uint32_t sequence) {
  const auto signal = [](std::int8_t dbm) {
    return [dbm](KernelMessage& info) {
      info.u8(NL80211_STA_INFO_SIGNAL, static_cast<std::uint8_t>(dbm));
    };
  };
  KernelMessage message(kNl80211Id, NL80211_CMD_NEW_STATION, sequence, NLM_F_MULTI);
  message.u32(NL80211_ATTR_IFINDEX, 3)
      .address(NL80211_ATTR_MAC, one.address)
      .nested(NL80211_ATTR_STA_INFO, [&](KernelMessage& info) {
        signal(one.signal_dbm)(info);
        info.u32(NL80211_STA_INFO_INACTIVE_TIME, one.inactive_ms);
      });
  if (!one.link_signals_dbm.empty()) {
    message.nested(kMloLinks, [&](KernelMessage& links) {
      int number = 1;
      for (const auto& [id, dbm] : one.link_signals_dbm) {
        links.nested(number++, [&, link = id, strength = dbm](KernelMessage& info) {
          info.u8(kMloLinkId, link).nested(NL80211_ATTR_STA_INFO, signal(strength));
        });
      }
    });
  }
  return message.take();
}

inline Bytes eventMessage(int command) {
  return KernelMessage(kNl80211Id, static_cast<std::uint8_t>(command), 0)
      .u32(NL80211_ATTR_IFINDEX, 3)
      .take();
}

/// The end of a dump, or an answer with an error; 0 acknowledges.
inline Bytes endMessage(std::uint16_t type, std::uint32_t sequence, int error) {
  nlmsghdr header{};
  const std::int32_t negative = -error;
  header.nlmsg_len = sizeof header + sizeof negative;
  header.nlmsg_type = type;
  header.nlmsg_seq = sequence;
  Bytes bytes(header.nlmsg_len);
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, &negative, sizeof negative);
  return bytes;
}

/// Stands in for the kernel below the netlink socket.
class SimulatedKernel : public NetlinkSocket {
 public:
  explicit SimulatedKernel(KernelState& state) : state_(state) {}

  void send(const Bytes& message) override {
    nlmsghdr header;
    std::memcpy(&header, message.data(), sizeof header);
    genlmsghdr generic;
    std::memcpy(&generic, message.data() + NLMSG_HDRLEN, sizeof generic);
    if (!state_.is_silent) {
      answer(header, generic.cmd);
    }
  }

  Bytes receive(std::chrono::milliseconds) override {
    if (datagrams_.empty()) {
      return {};
    }
    const Bytes first = datagrams_.front();
    datagrams_.pop_front();
    return first;
  }

  void join(std::uint32_t group) override { joined_ = group; }

 private:
  void answer(const nlmsghdr& request, int command) {
    const std::uint32_t sequence = request.nlmsg_seq;
    if (request.nlmsg_type == GENL_ID_CTRL) {
      datagrams_.push_back(state_.has_nl80211 ? familyMessage(sequence)
                                              : endMessage(NLMSG_ERROR, sequence, ENOENT));
      return;
    }
    if (const auto error = state_.errors.find(command); error != state_.errors.end()) {
      datagrams_.push_back(endMessage(NLMSG_ERROR, sequence, error->second));
      endScan(command);
      return;
    }
    Bytes datagram;
    const auto add = [&](const Bytes& message) {
      constexpr std::size_t kLargest = 4096;  // dumps come in several datagrams
      if (datagram.size() + message.size() > kLargest) {
        datagrams_.push_back(std::move(datagram));
        datagram.clear();
      }
      datagram.insert(datagram.end(), message.begin(), message.end());
    };
    if (command == NL80211_CMD_TRIGGER_SCAN) {
      datagrams_.push_back(endMessage(NLMSG_ERROR, sequence, 0));
      endScan(command);
      return;
    }
    if (command == NL80211_CMD_GET_INTERFACE) {
      for (const auto& one : state_.interfaces) {
        add(interfaceMessage(one, sequence));
      }
    } else if (command == NL80211_CMD_GET_SCAN) {
      for (const auto& one : state_.networks) {
        add(networkMessage(one, sequence));
      }
    } else {
      for (const auto& one : state_.stations) {
        add(stationMessage(one, sequence));
      }
    }
    add(endMessage(NLMSG_DONE, sequence, 0));
    datagrams_.push_back(datagram);
  }

  /// The events of a scan go to those that joined their group.
  void endScan(int command) {
    constexpr std::uint32_t kScanGroup = 6;
    if (command == NL80211_CMD_TRIGGER_SCAN && state_.after_scan && joined_ == kScanGroup) {
      if (state_.while_scanning) {
        state_.while_scanning(state_);
      }
      datagrams_.push_back(eventMessage(*state_.after_scan));
    }
  }

  KernelState& state_;
  std::deque<Bytes> datagrams_;
  std::optional<std::uint32_t> joined_;
};

}  // namespace sfw::test
