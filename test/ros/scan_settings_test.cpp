#include "ros/conversion/scan_settings.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sfw {
namespace {

ScanSettings settings() {
  ScanSettings settings;
  settings.type = "my/Scan";
  settings.readings = "networks";
  settings.bssid = "mac";
  settings.rssi = "level";
  return settings;
}

/// The names of the settings with a problem, after one of them was changed.
std::vector<std::string> brokenBy(const std::string& name, const std::string& value) {
  ScanSettings changed = settings();
  forEachScanSetting(changed, [&](const std::string& known, std::string& setting) {
    setting = known == "scan_format/" + name ? value : setting;
  });
  std::vector<std::string> names;
  for (const std::string& problem : validate(changed)) {
    names.push_back(problem.substr(0, problem.find(' ')));
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(ScanSettings, AreValidByDefault) {
  EXPECT_EQ(validate(ScanSettings()), Names());
  EXPECT_EQ(validate(settings()), Names());
}

TEST(ScanSettings, NeedATypeWithAPackage) {
  for (const char* type : {"Scan", "/Scan", "my/", "my/own/Scan"}) {
    EXPECT_EQ(brokenBy("type", type), Names{"scan_format/type"}) << type;
  }
  EXPECT_EQ(brokenBy("type", ""), Names{"scan_format/type"});  // but paths
}

TEST(ScanSettings, NeedAnAddressAndAStrength) {
  EXPECT_EQ(brokenBy("bssid", ""), Names{"scan_format/bssid"});
  EXPECT_EQ(brokenBy("rssi", ""), Names{"scan_format/rssi"});
  EXPECT_EQ(brokenBy("bssid", "02:00:00:00:00:01"), Names());
}

TEST(ScanSettings, HavePathsOfFields) {
  for (const char* path : {"a..b", ".a", "a.", "a b", "a/b", "[]", "a[]b", "a[0]"}) {
    EXPECT_EQ(brokenBy("rssi", path), Names{"scan_format/rssi"}) << path;
  }
  for (const char* path : {"a", "a.b_2", "a[]", "a[].b", "a.b[].c"}) {
    EXPECT_EQ(brokenBy("rssi", path), Names()) << path;
  }
}

TEST(ScanSettings, HaveKnownUnits) {
  EXPECT_EQ(brokenBy("unit", "dB"), Names{"scan_format/unit"});
  EXPECT_EQ(brokenBy("stamp_unit", "min"), Names{"scan_format/stamp_unit"});
  EXPECT_EQ(brokenBy("age_unit", ""), Names{"scan_format/age_unit"});
  ScanSettings percent = settings();
  percent.unit = "percent";
  ASSERT_EQ(validate(percent).size(), 1U);
  EXPECT_NE(validate(percent)[0].find("quality / 2 - 100"), std::string::npos);
}

TEST(ScanSettings, BecomeAFormat) {
  ScanSettings described = settings();
  described.unit = "mbm";
  described.age = "seen";
  described.age_unit = "ms";
  const ScanFormat format = toScanFormat(described);
  EXPECT_TRUE(isFor(format, "my/Scan"));
  EXPECT_FALSE(isFor(format, "other/Scan"));
  EXPECT_EQ(format.unit, SignalUnit::kHundredthDbm);
  EXPECT_EQ(format.age_unit_s, 1e-3);
  EXPECT_FALSE(isFor(toScanFormat(ScanSettings()), ""));
}

}  // namespace
}  // namespace sfw
