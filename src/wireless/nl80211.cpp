#include "wireless/nl80211.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace sfw {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kAnswerTime{2000};
constexpr std::chrono::milliseconds kStep{100};  // so that a stop is noticed

}  // namespace

Nl80211::Nl80211(std::unique_ptr<NetlinkSocket> socket, const std::atomic<bool>& stop)
    : socket_(std::move(socket)), stop_(stop) {
  std::optional<Nl80211Family> family;
  const std::uint32_t sequence = ++sequence_;
  ask(familyRequest(sequence), sequence, [&](const Bytes& message) {
    if (const auto found = parseFamily(message)) {
      family = found;
    }
  });
  if (!family) {
    throw WirelessError(ENOENT, "the kernel has no nl80211");
  }
  family_ = *family;
  if (family_.scan_group) {
    socket_->join(*family_.scan_group);
  }
}

std::vector<WirelessInterface> Nl80211::interfaces() {
  std::vector<WirelessInterface> result;
  const std::uint32_t sequence = ++sequence_;
  ask(interfacesRequest(family_, sequence), sequence, [&](const Bytes& message) {
    if (const auto one = parseInterface(message)) {
      result.push_back(*one);
    }
  });
  return result;
}

std::vector<HeardNetwork> Nl80211::networks(std::uint32_t interface) {
  std::vector<HeardNetwork> result;
  const std::uint32_t sequence = ++sequence_;
  ask(networksRequest(family_, interface, sequence), sequence, [&](const Bytes& message) {
    if (const auto one = parseNetwork(message)) {
      result.push_back(*one);
    }
  });
  return result;
}

std::vector<LinkedStation> Nl80211::stations(std::uint32_t interface) {
  std::vector<LinkedStation> result;
  const std::uint32_t sequence = ++sequence_;
  ask(stationsRequest(family_, interface, sequence), sequence, [&](const Bytes& message) {
    if (const auto one = parseStation(message)) {
      result.push_back(*one);
    }
  });
  return result;
}

void Nl80211::startScan(std::uint32_t interface) {
  events_.clear();
  const std::uint32_t sequence = ++sequence_;
  ask(scanRequest(family_, interface, sequence), sequence, [](const Bytes&) {});
}

Nl80211::ScanEnd Nl80211::awaitScan(std::uint32_t interface, std::chrono::milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + timeout;
  while (true) {
    while (!events_.empty()) {
      const ScanEvent event = events_.front();
      events_.pop_front();
      if (event.interface == interface) {
        return event.is_aborted ? ScanEnd::kAborted : ScanEnd::kDone;
      }
    }
    if (stop_ || Clock::now() >= deadline) {
      return ScanEnd::kTimeout;
    }
    receive();
  }
}

void Nl80211::ask(const Bytes& request, std::uint32_t sequence,
                  const std::function<void(const Bytes&)>& visit) {
  // A dump ends with a message of its own, any other answer with an acknowledgement or an error.
  // The question for the family is answered by a single message.
  socket_->send(request);
  const Clock::time_point deadline = Clock::now() + kAnswerTime;
  while (!stop_ && Clock::now() < deadline) {
    for (const Bytes& message : receive()) {
      const auto header = parseHeader(message);
      if (!header || header->sequence != sequence) {
        continue;
      }
      if (header->error.value_or(0) != 0) {
        throw WirelessError(*header->error, std::strerror(*header->error));
      }
      if (header->is_last || header->error) {
        return;
      }
      visit(message);
      if (parseFamily(message)) {
        return;
      }
    }
  }
  throw WirelessError(ETIMEDOUT, "the kernel gave no answer in time");
}

std::vector<Bytes> Nl80211::receive() {
  constexpr std::size_t kMostEvents = 100;
  std::vector<Bytes> messages = splitMessages(socket_->receive(kStep));
  for (const Bytes& message : messages) {
    const auto header = parseHeader(message);
    if (!header || header->sequence != 0) {
      continue;  // events have no sequence number
    }
    if (const auto event = parseScanEvent(message); event && events_.size() < kMostEvents) {
      events_.push_back(*event);
    }
  }
  return messages;
}

}  // namespace sfw
