#include "wireless/wireless_reader.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "wireless/simulated_kernel.h"

namespace sfw::test {
namespace {

constexpr Address kNear{0x02, 0, 0, 0, 0, 0x01};
constexpr Address kFar{0x02, 0, 0, 0, 0, 0x02};
constexpr Address kMultiLink{0x02, 0, 0, 0, 0, 0xff};

KernelState::Network network(const Address& bssid, std::int32_t signal_mbm, double heard_boot_s) {
  KernelState::Network result;
  result.bssid = bssid;
  result.signal_mbm = signal_mbm;
  result.heard_boot_ns = static_cast<std::uint64_t>(heard_boot_s * 1e9);
  return result;
}

class WirelessReaderTest : public testing::Test {
 protected:
  WirelessReader reader(WirelessMode mode, const std::string& interface = "") {
    return WirelessReader(
        {mode, interface}, stop_, [this] { return std::make_unique<SimulatedKernel>(kernel_); },
        [this] { return now_s_; });
  }

  /// A robot that is associated with the near access point.
  void associate() {
    kernel_.networks = {network(kNear, -5000, 99.0)};
    kernel_.networks[0].is_associated = true;
    kernel_.stations = {{kNear, -47, 30, {}}};
  }

  KernelState kernel_;
  std::atomic<bool> stop_{false};
  double now_s_ = 100.0;
};

TEST_F(WirelessReaderTest, TellsWhatTheCacheHolds) {
  kernel_.networks = {network(kNear, -4750, 99.5), network(kFar, -8100, 97.0)};
  kernel_.networks[1].ssid = "caf\xc3\xa9";
  kernel_.networks[1].frequency_mhz = 5180;
  const RadioReport report = reader(WirelessMode::kCache).look();
  EXPECT_EQ(report.problem, "");
  EXPECT_EQ(report.interface, "wlan0");
  ASSERT_EQ(report.readings.size(), 2U);
  EXPECT_EQ(report.readings[0].bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(report.readings[0].ssid, "home");
  EXPECT_DOUBLE_EQ(report.readings[0].rssi_dbm, -47.5);
  EXPECT_NEAR(report.readings[0].age_s, 0.5, 1e-9);
  EXPECT_EQ(report.readings[1].ssid, "caf\xc3\xa9");
  EXPECT_EQ(report.readings[1].frequency_mhz, 5180.0);
  EXPECT_NEAR(report.readings[1].age_s, 3.0, 1e-9);
}

TEST_F(WirelessReaderTest, UsesTheAgeOfKernelsThatTellNoTime) {
  kernel_.networks = {network(kNear, -5000, 0.0)};
  kernel_.networks[0].age_ms = 1200;
  const RadioReport report = reader(WirelessMode::kCache).look();
  ASSERT_EQ(report.readings.size(), 1U);
  EXPECT_NEAR(report.readings[0].age_s, 1.2, 1e-9);
}

TEST_F(WirelessReaderTest, TellsACachedValueOnce) {
  kernel_.networks = {network(kNear, -5000, 99.0), network(kFar, -7000, 99.0)};
  WirelessReader radio = reader(WirelessMode::kCache);
  EXPECT_EQ(radio.look().readings.size(), 2U);
  now_s_ = 101.0;
  EXPECT_TRUE(radio.look().readings.empty());
  kernel_.networks[1].heard_boot_ns += 500'000'000;
  const RadioReport report = radio.look();
  ASSERT_EQ(report.readings.size(), 1U);
  EXPECT_EQ(report.readings[0].bssid.str(), "02:00:00:00:00:02");
}

TEST_F(WirelessReaderTest, TellsTheSignalOfTheLink) {
  associate();
  kernel_.networks.push_back(network(kFar, -7000, 99.0));
  WirelessReader radio = reader(WirelessMode::kLink);
  const RadioReport report = radio.look();
  EXPECT_EQ(report.problem, "");
  ASSERT_EQ(report.readings.size(), 1U);
  EXPECT_EQ(report.readings[0].rssi_dbm, -47.0);  // of its last frame, not of the last scan
  EXPECT_NEAR(report.readings[0].age_s, 0.03, 1e-9);
  EXPECT_EQ(report.readings[0].ssid, "home");
  now_s_ += 0.05;
  kernel_.stations[0].inactive_ms = 80;  // no frame since
  EXPECT_TRUE(radio.look().readings.empty());
  kernel_.stations[0].inactive_ms = 0;
  EXPECT_EQ(radio.look().readings.size(), 1U);
}

TEST_F(WirelessReaderTest, PrefersTheLinkToItsOlderCopyInTheCache) {
  associate();
  const RadioReport report = reader(WirelessMode::kCache).look();
  ASSERT_EQ(report.readings.size(), 1U);
  EXPECT_EQ(report.readings[0].rssi_dbm, -47.0);
}

TEST_F(WirelessReaderTest, SaysThatTheRadioIsNotAssociated) {
  kernel_.networks = {network(kNear, -5000, 99.0)};
  const RadioReport report = reader(WirelessMode::kLink).look();
  EXPECT_TRUE(report.readings.empty());
  EXPECT_EQ(report.problem,
            "'wlan0' is associated with no access point: connect it, or use mode: cache or scan.");
}

TEST_F(WirelessReaderTest, NamesTheLinksOfWifi7AndNeverTheirCommonAddress) {
  kernel_.networks = {network(kNear, -5000, 99.0), network(kFar, -6000, 99.0)};
  for (std::uint8_t i = 0; i < 2; ++i) {
    kernel_.networks[i].is_associated = true;
    kernel_.networks[i].multi_link = kMultiLink;
    kernel_.networks[i].link_id = i;
  }
  kernel_.stations = {{kMultiLink, -41, 10, {{0, -52}, {1, -63}}}};
  const RadioReport report = reader(WirelessMode::kLink).look();
  ASSERT_EQ(report.readings.size(), 2U);
  EXPECT_EQ(report.readings[0].bssid.str(), "02:00:00:00:00:01");
  EXPECT_EQ(report.readings[0].rssi_dbm, -52.0);
  EXPECT_EQ(report.readings[1].bssid.str(), "02:00:00:00:00:02");
  EXPECT_EQ(report.readings[1].rssi_dbm, -63.0);

  // An older kernel tells one signal for all links: then those of the beacons count.
  kernel_.stations[0].link_signals_dbm.clear();
  const RadioReport older = reader(WirelessMode::kLink).look();
  ASSERT_EQ(older.readings.size(), 2U);
  EXPECT_EQ(older.readings[0].rssi_dbm, -50.0);
  EXPECT_NEAR(older.readings[0].age_s, 1.0, 1e-9);
}

TEST_F(WirelessReaderTest, ScansAndWaitsForTheEnd) {
  kernel_.after_scan = NL80211_CMD_NEW_SCAN_RESULTS;
  kernel_.while_scanning = [this](KernelState& state) {
    now_s_ = 103.0;
    state.networks = {network(kNear, -5000, 101.0), network(kFar, -7000, 102.0)};
  };
  const RadioReport report = reader(WirelessMode::kScan).look();
  EXPECT_EQ(report.problem, "");
  ASSERT_EQ(report.readings.size(), 2U);
  EXPECT_NEAR(report.readings[0].age_s, 2.0, 1e-9);
}

TEST_F(WirelessReaderTest, UsesTheScanOfAnotherProgram) {
  kernel_.networks = {network(kNear, -5000, 99.0)};
  kernel_.errors[NL80211_CMD_TRIGGER_SCAN] = EBUSY;
  kernel_.after_scan = NL80211_CMD_NEW_SCAN_RESULTS;
  const RadioReport report = reader(WirelessMode::kScan).look();
  EXPECT_EQ(report.problem, "");
  EXPECT_EQ(report.readings.size(), 1U);
}

TEST_F(WirelessReaderTest, SaysThatAScanWasAborted) {
  kernel_.after_scan = NL80211_CMD_SCAN_ABORTED;
  EXPECT_EQ(reader(WirelessMode::kScan).look().problem,
            "The scan on 'wlan0' was aborted by the driver: it scans again at the next look.");
}

TEST_F(WirelessReaderTest, TellsTheCacheWhereScansAreNotPermitted) {
  kernel_.networks = {network(kNear, -5000, 99.0)};
  kernel_.errors[NL80211_CMD_TRIGGER_SCAN] = EPERM;
  const RadioReport report = reader(WirelessMode::kScan).look();
  EXPECT_EQ(
      report.problem,
      "The kernel does not permit scans on 'wlan0': give the program CAP_NET_ADMIN, run it as "
      "root, or use mode: cache.");
  EXPECT_EQ(report.readings.size(), 1U);
}

TEST_F(WirelessReaderTest, SaysWhatToDoAboutEachFault) {
  const auto problem = [this](int error) {
    kernel_.errors[NL80211_CMD_TRIGGER_SCAN] = error;
    return reader(WirelessMode::kScan).look().problem;
  };
  EXPECT_EQ(problem(ENETDOWN), "The interface 'wlan0' is down: ip link set wlan0 up.");
  EXPECT_EQ(problem(ERFKILL), "The radio of 'wlan0' is switched off: rfkill unblock wifi.");
  EXPECT_EQ(problem(EOPNOTSUPP),
            "The driver of 'wlan0' does not support this mode: use mode: link or cache.");
  kernel_.interfaces.clear();
  EXPECT_EQ(reader(WirelessMode::kCache).look().problem,
            "No WiFi adapter is found: plug one in, and look whether its driver is loaded.");
  kernel_.has_nl80211 = false;
  EXPECT_EQ(reader(WirelessMode::kCache).look().problem,
            "The kernel has no nl80211, so no WiFi driver is loaded: load the driver of the "
            "adapter.");
}

TEST_F(WirelessReaderTest, SaysThatTheCacheIsEmpty) {
  EXPECT_EQ(reader(WirelessMode::kCache).look().problem,
            "The kernel's cache of 'wlan0' is empty, since no program scans: use mode: scan.");
}

TEST_F(WirelessReaderTest, RefusesSignalsWithoutUnit) {
  kernel_.networks = {network(kNear, 0, 99.0)};
  kernel_.networks[0].has_unit = false;
  const RadioReport report = reader(WirelessMode::kCache).look();
  EXPECT_TRUE(report.readings.empty());
  EXPECT_NE(report.problem.find("dBm are needed"), std::string::npos) << report.problem;
}

TEST_F(WirelessReaderTest, ChoosesAClientAndNamesTheOthers) {
  kernel_.interfaces = {{1, "mon0", NL80211_IFTYPE_MONITOR}, {3, "wlan0"}};
  kernel_.networks = {network(kNear, -5000, 99.0)};
  EXPECT_EQ(reader(WirelessMode::kCache).look().interface, "wlan0");
  EXPECT_EQ(reader(WirelessMode::kCache, "wlan9").look().problem,
            "The interface 'wlan9' is no WiFi adapter of this machine (mon0, wlan0): correct "
            "interface, or plug it in again.");
  kernel_.interfaces.pop_back();
  EXPECT_EQ(reader(WirelessMode::kCache).look().problem,
            "No WiFi adapter is a client of access points (mon0): name one with interface.");
}

TEST_F(WirelessReaderTest, GoesOnWhenTheAdapterIsBack) {
  kernel_.networks = {network(kNear, -5000, 99.0)};
  WirelessReader radio = reader(WirelessMode::kCache);
  EXPECT_EQ(radio.look().readings.size(), 1U);
  kernel_.errors[NL80211_CMD_GET_SCAN] = ENODEV;
  EXPECT_EQ(radio.look().problem, "The interface 'wlan0' is gone: plug the adapter in again.");
  kernel_.errors.clear();
  kernel_.interfaces[0].index = 4;
  kernel_.networks[0].heard_boot_ns += 1'000'000'000;
  const RadioReport report = radio.look();
  EXPECT_EQ(report.problem, "");
  EXPECT_EQ(report.readings.size(), 1U);
}

TEST_F(WirelessReaderTest, ReadsDumpsOfSeveralDatagrams) {
  for (int i = 0; i < 500; ++i) {
    kernel_.networks.push_back(network(
        {0x02, 0, 0, 1, static_cast<std::uint8_t>(i / 200), static_cast<std::uint8_t>(i % 200)},
        -6000, 99.0));
  }
  EXPECT_EQ(reader(WirelessMode::kCache).look().readings.size(), 500U);
}

TEST_F(WirelessReaderTest, KeepsAnySsid) {
  for (const std::string& ssid : {std::string(32, '\0'), std::string("\xff\xfe"), std::string()}) {
    kernel_.networks = {network(kNear, -5000, 99.0)};
    kernel_.networks[0].ssid = ssid;
    const RadioReport report = reader(WirelessMode::kCache).look();
    ASSERT_EQ(report.readings.size(), 1U);
    EXPECT_EQ(report.readings[0].ssid, ssid);
  }
}

TEST_F(WirelessReaderTest, EndsAtOnceWhenItHasToStop) {
  kernel_.is_silent = true;
  stop_ = true;
  EXPECT_TRUE(reader(WirelessMode::kScan).look().readings.empty());
}

TEST(KernelSocket, ReachesTheRunningKernel) {
  const std::atomic<bool> stop{false};
  const RadioReport report = WirelessReader({WirelessMode::kCache, ""}, stop).look();
  if (report.interface.empty()) {
    EXPECT_NE(report.problem, "");
    GTEST_SKIP() << "no WiFi adapter here (mac80211_hwsim would be one): " << report.problem;
  }
  for (const RadioReading& reading : report.readings) {
    EXPECT_LT(reading.rssi_dbm, 1.0);
    EXPECT_GT(reading.frequency_mhz, 2000.0);
  }
}

}  // namespace
}  // namespace sfw::test
