#include "wireless/nl80211_messages.h"

#include <gtest/gtest.h>

#include <random>

#include "wireless/simulated_kernel.h"

namespace sfw::test {
namespace {

/// A message of each kind that the kernel sends.
std::vector<Bytes> allMessages() {
  KernelState::Network network;
  network.bssid = {0x02, 0, 0, 0, 0, 1};
  network.heard_boot_ns = 99'000'000'000;
  network.is_associated = true;
  network.multi_link = Address{0x02, 0, 0, 0, 0, 9};
  const KernelState::Station station{{0x02, 0, 0, 0, 0, 9}, -50, 10, {{0, -40}, {2, -60}}};
  return {familyMessage(1),
          interfaceMessage({}, 2),
          networkMessage(network, 3),
          stationMessage(station, 4),
          eventMessage(NL80211_CMD_NEW_SCAN_RESULTS),
          eventMessage(NL80211_CMD_SCAN_ABORTED),
          endMessage(NLMSG_ERROR, 5, 1),
          endMessage(NLMSG_DONE, 6, 0)};
}

/// The number of parsers that take a message for theirs.
int takers(const Bytes& message) {
  return (parseFamily(message) ? 1 : 0) + (parseInterface(message) ? 1 : 0) +
         (parseNetwork(message) ? 1 : 0) + (parseStation(message) ? 1 : 0) +
         (parseScanEvent(message) ? 1 : 0);
}

TEST(Nl80211Messages, EachIsTakenByOneParser) {
  const std::vector<Bytes> messages = allMessages();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const std::vector<Bytes> parts = splitMessages(messages[i]);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(takers(parts[0]), i < 6 ? 1 : 0) << i;
  }
  EXPECT_EQ(parseFamily(splitMessages(messages[0])[0])->scan_group, 6U);
  EXPECT_FALSE(parseScanEvent(splitMessages(messages[4])[0])->is_aborted);
  EXPECT_TRUE(parseScanEvent(splitMessages(messages[5])[0])->is_aborted);
  EXPECT_EQ(parseHeader(splitMessages(messages[6])[0])->error, 1);
  EXPECT_TRUE(parseHeader(splitMessages(messages[7])[0])->is_last);
}

TEST(Nl80211Messages, CutOnesAreLeftOut) {
  for (const Bytes& message : allMessages()) {
    for (std::size_t size = 0; size + 4 < message.size(); ++size) {
      const Bytes cut(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_TRUE(splitMessages(cut).empty());
      EXPECT_EQ(takers(cut), 0);
    }
  }
}

TEST(Nl80211Messages, BrokenOnesAreReadWithinTheirBounds) {
  std::mt19937 random(1);
  const std::vector<Bytes> messages = allMessages();
  int taken = 0;
  for (int i = 0; i < 40000; ++i) {
    Bytes broken = messages[random() % messages.size()];
    const Bytes& other = messages[random() % messages.size()];
    broken.insert(broken.end(), other.begin(), other.end());
    for (std::size_t changes = 1 + random() % 8; changes > 0; --changes) {
      broken[random() % broken.size()] = static_cast<std::uint8_t>(random());
    }
    broken.resize(random() % broken.size() + 1);
    for (const Bytes& message : splitMessages(broken)) {
      taken += takers(Bytes(message));  // a copy of its own, so that a sanitizer sees its end
      if (const auto network = parseNetwork(message)) {
        EXPECT_LE(network->ssid.size(), 255U);
      }
    }
  }
  EXPECT_GT(taken, 1000);
}

}  // namespace
}  // namespace sfw::test
