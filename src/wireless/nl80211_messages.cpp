#include "wireless/nl80211_messages.h"

#include <linux/nl80211.h>
#include <netlink/attr.h>
#include <netlink/genl/ctrl.h>
#include <netlink/genl/genl.h>
#include <netlink/msg.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include "wireless/netlink_attributes.h"

namespace sfw {
namespace {

// linux/nl80211.h of Debian 11 does not know several links yet. Linux never renumbers these.
constexpr int kAttrMloLinks = 312;
constexpr int kAttrMloLinkId = 313;
constexpr int kBssMloLinkId = 21;
constexpr int kBssMldAddress = 22;

constexpr double kMillibel = 100.0;  // of a dBm
constexpr double kMilliseconds = 1e3;
constexpr double kNanoseconds = 1e9;

struct FreeMessage {
  void operator()(nl_msg* message) const { nlmsg_free(message); }
};

/// A request to generic netlink, with an interface if that is not 0.
Bytes request(std::uint16_t family, std::uint8_t command, int flags, std::uint32_t interface,
              std::uint32_t sequence, const char* family_name = nullptr) {
  const std::unique_ptr<nl_msg, FreeMessage> message(nlmsg_alloc());
  if (!message ||
      genlmsg_put(message.get(), NL_AUTO_PORT, sequence, family, 0, NLM_F_REQUEST | flags, command,
                  family_name != nullptr ? 1 : 0) == nullptr) {
    throw WirelessError(0, "a netlink message could not be made: there is no memory");
  }
  if (family_name != nullptr) {
    nla_put_string(message.get(), CTRL_ATTR_FAMILY_NAME, family_name);
  }
  if (interface != 0) {
    nla_put_u32(message.get(), NL80211_ATTR_IFINDEX, interface);
  }
  const nlmsghdr* header = nlmsg_hdr(message.get());
  const auto* begin = reinterpret_cast<const std::uint8_t*>(header);
  return Bytes(begin, begin + header->nlmsg_len);
}

using MainAttributes = Attributes<kAttrMloLinkId>;
using BssAttributes = Attributes<kBssMldAddress>;
using StationAttributes = Attributes<NL80211_STA_INFO_MAX>;
using ControlAttributes = Attributes<CTRL_ATTR_MAX>;

/// The network's name among the information elements of a beacon.
std::string ssidOf(const nlattr* elements) {
  if (elements == nullptr) {
    return {};
  }
  constexpr std::uint8_t kSsid = 0;
  constexpr int kHeader = 2;
  const auto* at = static_cast<const std::uint8_t*>(nla_data(elements));
  for (int left = nla_len(elements); left >= kHeader;) {
    const int length = at[1];
    if (left < kHeader + length) {
      break;
    }
    if (at[0] == kSsid) {
      return std::string(reinterpret_cast<const char*>(at + kHeader),
                         static_cast<std::size_t>(length));
    }
    at += kHeader + length;
    left -= kHeader + length;
  }
  return {};
}

/// The signal of a frame [dBm]. The kernel keeps it in one signed byte.
std::optional<double> signalOf(const StationAttributes& station) {
  const auto signal = station.number<std::int8_t>(NL80211_STA_INFO_SIGNAL);
  return signal ? std::optional<double>(*signal) : std::nullopt;
}

}  // namespace

Bytes familyRequest(std::uint32_t sequence) {
  return request(GENL_ID_CTRL, CTRL_CMD_GETFAMILY, 0, 0, sequence, NL80211_GENL_NAME);
}

Bytes interfacesRequest(const Nl80211Family& family, std::uint32_t sequence) {
  return request(family.id, NL80211_CMD_GET_INTERFACE, NLM_F_DUMP, 0, sequence);
}

Bytes networksRequest(const Nl80211Family& family, std::uint32_t interface,
                      std::uint32_t sequence) {
  return request(family.id, NL80211_CMD_GET_SCAN, NLM_F_DUMP, interface, sequence);
}

Bytes stationsRequest(const Nl80211Family& family, std::uint32_t interface,
                      std::uint32_t sequence) {
  return request(family.id, NL80211_CMD_GET_STATION, NLM_F_DUMP, interface, sequence);
}

Bytes scanRequest(const Nl80211Family& family, std::uint32_t interface, std::uint32_t sequence) {
  return request(family.id, NL80211_CMD_TRIGGER_SCAN, NLM_F_ACK, interface, sequence);
}

std::optional<Nl80211Family> parseFamily(const Bytes& message) {
  const auto attributes = ControlAttributes::of(message, CTRL_CMD_NEWFAMILY);
  if (!attributes || attributes->text(CTRL_ATTR_FAMILY_NAME) != NL80211_GENL_NAME) {
    return std::nullopt;
  }
  const auto id = attributes->number<std::uint16_t>(CTRL_ATTR_FAMILY_ID);
  if (!id) {
    return std::nullopt;
  }
  Nl80211Family family{*id, std::nullopt};
  forEachInside(attributes->at(CTRL_ATTR_MCAST_GROUPS), [&](const nlattr* one) {
    const auto group = Attributes<CTRL_ATTR_MCAST_GRP_MAX>::inside(one);
    if (group.text(CTRL_ATTR_MCAST_GRP_NAME) == NL80211_MULTICAST_GROUP_SCAN) {
      family.scan_group = group.number<std::uint32_t>(CTRL_ATTR_MCAST_GRP_ID);
    }
  });
  return family;
}

std::optional<WirelessInterface> parseInterface(const Bytes& message) {
  const auto attributes = MainAttributes::of(message, NL80211_CMD_NEW_INTERFACE);
  const auto index = attributes ? attributes->number<std::uint32_t>(NL80211_ATTR_IFINDEX)
                                : std::optional<std::uint32_t>();
  if (!index) {
    return std::nullopt;  // a device for peer-to-peer has none
  }
  const auto type = attributes->number<std::uint32_t>(NL80211_ATTR_IFTYPE);
  return WirelessInterface{*index, attributes->text(NL80211_ATTR_IFNAME),
                           type == std::uint32_t{NL80211_IFTYPE_STATION}};
}

std::optional<HeardNetwork> parseNetwork(const Bytes& message) {
  const auto attributes = MainAttributes::of(message, NL80211_CMD_NEW_SCAN_RESULTS);
  if (!attributes || attributes->at(NL80211_ATTR_BSS) == nullptr) {
    return std::nullopt;
  }
  const auto bss = BssAttributes::inside(attributes->at(NL80211_ATTR_BSS));
  const auto bssid = bss.address(NL80211_BSS_BSSID);
  if (!bssid) {
    return std::nullopt;
  }
  HeardNetwork network;
  network.bssid = *bssid;
  network.multi_link = bss.address(kBssMldAddress);
  network.link_id = bss.number<std::uint8_t>(kBssMloLinkId);
  network.ssid = ssidOf(bss.at(NL80211_BSS_INFORMATION_ELEMENTS));
  network.frequency_mhz = bss.number<std::uint32_t>(NL80211_BSS_FREQUENCY).value_or(0);
  if (const auto mbm = bss.number<std::int32_t>(NL80211_BSS_SIGNAL_MBM)) {
    network.rssi_dbm = *mbm / kMillibel;
  }
  if (const auto seen = bss.number<std::uint64_t>(NL80211_BSS_LAST_SEEN_BOOTTIME)) {
    network.heard_boot_s = static_cast<double>(*seen) / kNanoseconds;
  }
  network.age_s = bss.number<std::uint32_t>(NL80211_BSS_SEEN_MS_AGO).value_or(0) / kMilliseconds;
  network.is_associated =
      bss.number<std::uint32_t>(NL80211_BSS_STATUS) == std::uint32_t{NL80211_BSS_STATUS_ASSOCIATED};
  return network;
}

std::optional<LinkedStation> parseStation(const Bytes& message) {
  const auto attributes = MainAttributes::of(message, NL80211_CMD_NEW_STATION);
  const auto address = attributes ? attributes->address(NL80211_ATTR_MAC) : std::optional<Bssid>();
  if (!address) {
    return std::nullopt;
  }
  const auto info = StationAttributes::inside(attributes->at(NL80211_ATTR_STA_INFO));
  LinkedStation station{*address, signalOf(info), 0.0, {}};
  station.inactive_s =
      info.number<std::uint32_t>(NL80211_STA_INFO_INACTIVE_TIME).value_or(0) / kMilliseconds;
  forEachInside(attributes->at(kAttrMloLinks), [&](const nlattr* one) {
    const auto link = MainAttributes::inside(one);
    if (const auto id = link.number<std::uint8_t>(kAttrMloLinkId)) {
      station.links.push_back(
          {*id, signalOf(StationAttributes::inside(link.at(NL80211_ATTR_STA_INFO)))});
    }
  });
  return station;
}

std::optional<ScanEvent> parseScanEvent(const Bytes& message) {
  for (const bool is_aborted : {false, true}) {
    const auto attributes = MainAttributes::of(
        message, is_aborted ? NL80211_CMD_SCAN_ABORTED : NL80211_CMD_NEW_SCAN_RESULTS);
    // The networks of a dump have the command of the event, too.
    if (attributes && attributes->at(NL80211_ATTR_BSS) == nullptr) {
      if (const auto index = attributes->number<std::uint32_t>(NL80211_ATTR_IFINDEX)) {
        return ScanEvent{*index, is_aborted};
      }
    }
  }
  return std::nullopt;
}

std::vector<Bytes> splitMessages(const Bytes& datagram) {
  std::vector<Bytes> messages;
  std::size_t at = 0;
  while (datagram.size() - at >= sizeof(nlmsghdr)) {
    nlmsghdr header;
    std::memcpy(&header, datagram.data() + at, sizeof header);
    if (header.nlmsg_len < sizeof header || header.nlmsg_len > datagram.size() - at) {
      break;
    }
    const auto begin = datagram.begin() + static_cast<std::ptrdiff_t>(at);
    messages.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(header.nlmsg_len));
    at = std::min<std::size_t>(datagram.size(), at + NLMSG_ALIGN(header.nlmsg_len));
  }
  return messages;
}

std::optional<MessageHeader> parseHeader(const Bytes& message) {
  nlmsghdr header;
  if (message.size() < sizeof header) {
    return std::nullopt;
  }
  std::memcpy(&header, message.data(), sizeof header);
  if (header.nlmsg_len != message.size()) {
    return std::nullopt;
  }
  MessageHeader result{header.nlmsg_type, header.nlmsg_seq, header.nlmsg_type == NLMSG_DONE, {}};
  if (header.nlmsg_type == NLMSG_ERROR || header.nlmsg_type == NLMSG_DONE) {
    std::int32_t error = 0;  // negative in messages
    if (message.size() >= sizeof header + sizeof error) {
      std::memcpy(&error, message.data() + sizeof header, sizeof error);
    } else if (header.nlmsg_type == NLMSG_ERROR) {
      return std::nullopt;
    }
    if (header.nlmsg_type == NLMSG_ERROR || error < 0) {
      result.error = error == std::numeric_limits<std::int32_t>::min() ? 0 : -error;
    }
  }
  return result;
}

}  // namespace sfw
