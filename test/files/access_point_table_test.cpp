#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>

#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

std::vector<AccessPoint> fromText(const std::string& table) {
  return accessPointsFromYaml(YAML::Load(table)).access_points;
}

/// What is complained of, one problem a line.
std::string complaintOf(const std::string& table) {
  try {
    fromText(table);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

const std::string kGood = "{bssid: '02:00:00:00:00:01', x: 1, y: 2}";

TEST(AccessPointTable, IsReadWithAllItsFields) {
  const auto table = fromText(
      "[{bssid: 02-00-00-00-00-AB, x: -1.5, y: 2e1, z: 2.2, "
      "name: \"K\xc3\xbc"
      "che\", tx_dbm: 17}, " +
      kGood + "]");
  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0].bssid.str(), "02:00:00:00:00:ab");
  EXPECT_EQ(table[0].position, Position(-1.5, 20.0));
  EXPECT_EQ(table[0].height_m, 2.2);
  EXPECT_EQ(table[0].tx_dbm, 17.0);
  EXPECT_EQ(table[0].name,
            "K\xc3\xbc"
            "che");
  EXPECT_EQ(table[1].position, Position(1.0, 2.0));
  EXPECT_FALSE(table[1].height_m);
  EXPECT_FALSE(table[1].tx_dbm);
  EXPECT_EQ(table[1].name, "");
}

TEST(AccessPointTable, MustBeAList) {
  const std::string complaint = "access_points must be a list of {bssid, x, y}";
  for (const std::string table : {"", "{}", "text", "7", "{bssid: x}"}) {
    EXPECT_EQ(complaintOf(table), complaint) << table;
  }
}

TEST(AccessPointTable, NamesEntryAndFieldOfEachFault) {
  EXPECT_EQ(complaintOf("[" + kGood + ", 5]"),
            "access_points[1]: must be a map with bssid and, if known, x and y");
  EXPECT_EQ(complaintOf("[{x: 1, y: 2}]"), "access_points[0]: 'bssid' is missing");
  EXPECT_EQ(complaintOf("[{bsid: '02:00:00:00:00:01', x: 1, y: 2}]"),
            "access_points[0]: 'bssid' is missing\naccess_points[0]: 'bsid' is not read; an access "
            "point has bssid, x, y, position_sd, z, name and tx_dbm");
  EXPECT_EQ(complaintOf("[{bssid: 190000000000000, x: 1, y: 2}]"),
            "access_points[0]: 'bssid' must look like '02:00:00:00:00:01'; it is "
            "'190000000000000': YAML reads it as a number, so quote it");
  EXPECT_EQ(complaintOf("[{bssid: 2:0:0:0:0:1, x: 1, y: 2}]"),
            "access_points[0]: 'bssid' must look like '02:00:00:00:00:01'; it is '2:0:0:0:0:1'");
  EXPECT_NE(complaintOf("[{bssid: '00:00:00:00:00:00', x: 1, y: 2}]"), "nothing");
  EXPECT_NE(complaintOf("[{bssid: [1], x: 1, y: 2}]"), "nothing");
  EXPECT_EQ(complaintOf("[{bssid: '02:00:00:00:00:01', y: 2}]"),
            "access_points[0]: 'x' is missing");
  EXPECT_EQ(complaintOf("[{bssid: '02:00:00:00:00:01', x: 1}]"),
            "access_points[0]: 'y' is missing");
}

TEST(AccessPointTable, TakesAnAccessPointWithoutPositionToEstimateIt) {
  const auto table = fromText("[{bssid: '02:00:00:00:00:09', z: 2}, " + kGood + "]");
  EXPECT_FALSE(table[0].position_known);
  EXPECT_EQ(table[0].height_m, 2.0);
  EXPECT_TRUE(table[1].position_known);
}

TEST(AccessPointTable, TakesAStandardDeviationOfThePosition) {
  const auto table =
      fromText("[{bssid: '02:00:00:00:00:09', x: 1, y: 2, position_sd: 1.5}, " + kGood + "]");
  EXPECT_EQ(table[0].position_sd_m, 1.5);
  EXPECT_FALSE(table[1].position_sd_m);
  const auto again = fromText(YAML::Dump(YAML::Load(accessPointsYaml(table))["access_points"]));
  EXPECT_EQ(again[0].position_sd_m, 1.5);
  EXPECT_FALSE(again[1].position_sd_m);
}

TEST(AccessPointTable, RefusesAStandardDeviationThatMeansNothing) {
  const auto complaint = [](const std::string& fields) {
    return complaintOf("[{bssid: '02:00:00:00:00:09', " + fields + "}]");
  };
  const std::string small =
      "access_points[0]: 'position_sd' must be at least 0.01 m; leave it out if the position is "
      "exact";
  EXPECT_EQ(complaint("x: 1, y: 2, position_sd: 0"), small);
  EXPECT_EQ(complaint("x: 1, y: 2, position_sd: -3"), small);
  EXPECT_EQ(complaint("x: 1, y: 2, position_sd: wide"),
            "access_points[0]: 'position_sd' must be a number from -1e6 to 1e6; it is 'wide'");
  EXPECT_EQ(complaint("position_sd: 2"),
            "access_points[0]: 'position_sd' needs x and y, whose standard deviation it is");
}

TEST(AccessPointTable, ReadsBssidsWithoutQuotes) {
  for (const std::string text :
       {"52:54:00:12:34:56", "525400123456", "5254.0012.3456", "52-54-00-12-34-56"}) {
    EXPECT_EQ(fromText("[{bssid: " + text + "}]")[0].bssid.str(), "52:54:00:12:34:56") << text;
  }
}

TEST(AccessPointTable, TellsOfDecimalCommas) {
  EXPECT_EQ(complaintOf("[{bssid: '02:00:00:00:00:01', x: 2,6, y: 1}]"),
            "access_points[0]: '6' follows a comma within a number; write a decimal point");
  EXPECT_EQ(
      complaintOf("- bssid: '02:00:00:00:00:01'\n  x: 2,6\n  y: 1\n"),
      "access_points[0]: 'x' must be a number from -1e8 to 1e8, with a decimal point; it is '2,6'");
}

TEST(AccessPointTable, AsksForFiniteNumbers) {
  using Given = std::pair<std::string, std::string>;  // in the file, in the complaint
  for (const auto& [bad, told] :
       {Given(".nan", "'.nan'"), Given(".inf", "'.inf'"), Given("nan", "'nan'"),
        Given("inf", "'inf'"), Given("-inf", "'-inf'"), Given("far", "'far'"),
        Given("[1]", "a list"), Given("{}", "a group"), Given("", "empty"),
        Given("200000000", "'200000000'"), Given("1.0 m", "'1.0 m'")}) {
    for (const std::string key : {"x", "z", "tx_dbm"}) {
      const std::string position = key == "x" ? "y: 1" : "x: 1, y: 1";
      const std::string complaint =
          complaintOf("[{bssid: '02:00:00:00:00:01', " + position + ", " + key + ": " + bad + "}]");
      const std::string limit = key == "x" ? "1e8" : "1e6";
      EXPECT_EQ(complaint, "access_points[0]: '" + key + "' must be a number from -" + limit +
                               " to " + limit + "; it is " + told)
          << bad;
    }
  }
}

TEST(AccessPointTable, WarnsOfKeysThatNobodyReads) {
  const auto warnings = [](const std::string& table) {
    return accessPointsFromYaml(YAML::Load(table)).warnings;
  };
  EXPECT_TRUE(warnings("[" + kGood +
                       ", {bssid: '02:00:00:00:00:02', x: 0, y: 0, z: 2, "
                       "name: attic, tx_dbm: 20}]")
                  .empty());
  EXPECT_EQ(warnings("[" + kGood + ", {bssid: '02:00:00:00:00:02', x: 0, y: 0, hieght: 2}]"),
            std::vector<std::string>{"access_points[1]: 'hieght' is not read; an access point has "
                                     "bssid, x, y, position_sd, z, name and tx_dbm"});
  EXPECT_EQ(warnings("[{bssid: '02:00:00:00:00:02', [1, 2]: 3}]").size(), 1U);
}

TEST(AccessPointTable, RefusesARadioThatStandsInItTwice) {
  EXPECT_EQ(complaintOf("[" + kGood +
                        ", {bssid: '02:00:00:00:00:02', x: 0, y: 0}, "
                        "{bssid: 02-00-00-00-00-01, x: 5, y: 5}]"),
            "access_points[2]: 02:00:00:00:00:01 is in the list twice");
}

TEST(AccessPointTable, NamesAllFaultsAtOnce) {
  EXPECT_EQ(complaintOf("[{bssid: a, x: 1}, {bssid: b, x: 1, y: nowhere}]"),
            "access_points[0]: 'bssid' must look like '02:00:00:00:00:01'; it is 'a'\n"
            "access_points[0]: 'y' is missing\n"
            "access_points[1]: 'bssid' must look like '02:00:00:00:00:01'; it is 'b'\n"
            "access_points[1]: 'y' must be a number from -1e8 to 1e8; it is 'nowhere'");
}

TEST(AccessPointTable, NamesItsFile) {
  const std::string file = ::testing::TempDir() + "/no_such_table.yaml";
  try {
    readAccessPoints(file);
    FAIL() << "a missing file was read";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file + ": ", 0), 0U) << error.what();
  }
}

}  // namespace
}  // namespace sfw
