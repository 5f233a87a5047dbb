#include "access_points/radio_groups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "base/random.h"
#include "simulation/radio/random_field.h"
#include "support/recorded_readings.h"

namespace sfw {
namespace {

using Readings = std::vector<Reading>;

AccessPoint unplaced(const std::string& bssid) {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse(bssid);
  access_point.position_known = false;
  return access_point;
}

/// A drive of 30 m past access points that all stand at one place.
class Drive {
 public:
  /// Adds a BSSID. Those of one radio share its fading.
  /// @param at_m  where it is passed on the way
  void hear(const std::string& bssid, std::uint64_t radio, double noise_db = 1.0,
            double offset_db = 0.0, double delay_s = 0.0, double at_m = 12.0,
            double fading_db = 4.0) {
    const RandomField fading(RandomField::Kind::kRough, 0.6, 7, radio);
    Random random(5, static_cast<std::int64_t>(table.size()), 6);
    table.push_back(unplaced(bssid));
    readings.emplace_back();
    for (int i = 0; i < 150; ++i) {
      const Position place(0.2 * i, 1.0);
      const double distance = std::hypot(place.x() - at_m, 3.0);
      Reading reading;
      reading.stamp_ns = static_cast<std::int64_t>((0.5 * i + delay_s) * 1e9);
      reading.antenna_in_map = place;
      reading.bssid = table.back().bssid;
      reading.rssi_dbm = std::round(-40.0 - 20.0 * std::log10(distance) + offset_db +
                                    fading_db * fading.at(place) + noise_db * random.normal());
      readings.back().push_back(reading);
    }
  }

  std::vector<RadioGroup> groups() const { return groupByRadio(table, readings); }

  std::vector<AccessPoint> table;
  std::vector<Readings> readings;
};

TEST(RadioGroups, AreNoneWithoutReadings) {
  EXPECT_TRUE(groupByRadio({}, {}).empty());
  EXPECT_TRUE(groupByRadio({unplaced("aa:00:00:00:00:01"), unplaced("aa:00:00:00:00:02")},
                           {Readings(), Readings()})
                  .empty());
}

TEST(RadioGroups, JoinTheNetworksOfARadio) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:80", 2);
  drive.hear("a0:00:00:00:00:41", 1);
  drive.hear("a2:00:00:00:00:40", 1);  // a variant of local administration
  EXPECT_EQ(drive.groups(), (std::vector<RadioGroup>{{0, 2, 3}}));
}

TEST(RadioGroups, KeepTwoRadiosOfOneMastApart) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:41", 2);
  EXPECT_TRUE(drive.groups().empty());
}

TEST(RadioGroups, KeepRadiosOfTwoPlacesApartWithoutFading) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1, 1.0, 0.0, 0.0, 12.0, 0.0);
  drive.hear("a0:00:00:00:00:41", 2, 1.0, 0.0, 0.0, 15.0, 0.0);
  EXPECT_TRUE(drive.groups().empty());
}

TEST(RadioGroups, NeedBothToBeHeardAsFar) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:41", 1);
  drive.readings[1].resize(8);  // these few could be alike by chance
  EXPECT_TRUE(drive.groups().empty());
  drive.readings[0].resize(8);
  EXPECT_EQ(drive.groups().size(), 1U);
}

TEST(RadioGroups, JoinNetworksOfDifferentPower) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:41", 1, 1.0, 8.0);
  EXPECT_EQ(drive.groups(), (std::vector<RadioGroup>{{0, 1}}));
}

TEST(RadioGroups, JoinUnrelatedAddressesWithTheSameSignals) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("bc:12:34:56:78:90", 1);
  EXPECT_EQ(drive.groups(), (std::vector<RadioGroup>{{0, 1}}));
}

TEST(RadioGroups, NeedSimultaneousReadings) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:41", 1, 1.0, 0.0, 0.1);
  EXPECT_EQ(drive.groups(), (std::vector<RadioGroup>{{0, 1}}));
  for (Reading& reading : drive.readings[1]) {
    reading.stamp_ns += 1'000'000'000'000;
  }
  EXPECT_TRUE(drive.groups().empty());
}

TEST(RadioGroups, BelieveATableThatGivesTwoPlaces) {
  Drive drive;
  drive.hear("a0:00:00:00:00:40", 1);
  drive.hear("a0:00:00:00:00:41", 1);
  for (AccessPoint& access_point : drive.table) {
    access_point.position_known = true;
  }
  EXPECT_EQ(drive.groups().size(), 1u);
  drive.table[1].position = {5.0, 0.0};
  EXPECT_TRUE(drive.groups().empty());
}

/// What the readings of a file give.
struct Grouped {
  std::map<std::string, std::set<std::string>> group_of;
  std::map<std::string, std::size_t> readings;
};

Grouped groupedBssids(const std::string& file) {
  std::map<Bssid, Readings> by_bssid;
  for (const Reading& reading : readReadings(file).readings) {
    by_bssid[reading.bssid].push_back(reading);
  }
  std::vector<AccessPoint> table;
  std::vector<Readings> readings;
  Grouped grouped;
  for (const auto& [bssid, own] : by_bssid) {
    table.push_back(unplaced(bssid.str()));
    readings.push_back(own);
    grouped.group_of[bssid.str()] = {bssid.str()};
    grouped.readings[bssid.str()] = own.size();
  }
  for (const RadioGroup& group : groupByRadio(table, readings)) {
    std::set<std::string> names;
    for (const std::size_t i : group) {
      names.insert(table[i].bssid.str());
    }
    for (const std::string& name : names) {
      grouped.group_of[name] = names;
    }
  }
  return grouped;
}

TEST(RadioGroups, AreRightInARealOffice) {
  const std::string file = test::recordingFile("office_robot/readings.csv");
  if (file.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  // In this building, all but the first octet and the last digit name the radio.
  const auto radio = [](const std::string& bssid) { return bssid.substr(3, 13); };
  constexpr std::size_t kFewest = 5;
  const Grouped grouped = groupedBssids(file);
  std::size_t examined = 0;
  std::size_t right = 0;
  for (const auto& [bssid, group] : grouped.group_of) {
    if (grouped.readings.at(bssid) < kFewest) {
      continue;
    }
    ++examined;
    bool is_right = true;
    for (const auto& [other, count] : grouped.readings) {
      const bool is_one = radio(other) == radio(bssid);
      is_right = is_right && (count < kFewest || is_one == (group.count(other) > 0));
    }
    right += is_right ? 1 : 0;
  }
  EXPECT_EQ(examined, 146u);
  EXPECT_GE(static_cast<double>(right), 0.95 * static_cast<double>(examined));
}

TEST(RadioGroups, AreNoneInRealHomes) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  for (const test::RealRecording& recording : recordings) {
    for (const auto& [bssid, group] : groupedBssids(recording.file).group_of) {
      EXPECT_EQ(group.size(), 1u) << recording.name << " " << bssid;
    }
  }
}

}  // namespace
}  // namespace sfw
