#include "ros/conversion/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using XmlRpc::XmlRpcValue;

XmlRpcValue accessPoint(const std::string& bssid, const XmlRpcValue& x, const XmlRpcValue& y) {
  XmlRpcValue entry;
  entry["bssid"] = bssid;
  entry["x"] = x;
  entry["y"] = y;
  return entry;
}

TEST(ToYaml, ConvertsScalars) {
  EXPECT_EQ(toYaml(XmlRpcValue(true)).as<bool>(), true);
  EXPECT_EQ(toYaml(XmlRpcValue(-7)).as<int>(), -7);
  EXPECT_EQ(toYaml(XmlRpcValue("1 two")).as<std::string>(), "1 two");
  EXPECT_TRUE(toYaml(XmlRpcValue()).IsNull());
}

TEST(ToYaml, KeepsEveryBitOfADouble) {
  for (const double value :
       {0.1, -1.0 / 3.0, 1e-300, 5e-324, 123456789.123456789, std::numeric_limits<double>::max()}) {
    EXPECT_EQ(toYaml(XmlRpcValue(value)).as<double>(), value);
  }
  EXPECT_TRUE(std::isnan(toYaml(XmlRpcValue(std::nan(""))).as<double>()));
  EXPECT_LT(toYaml(XmlRpcValue(-HUGE_VAL)).as<double>(), std::numeric_limits<double>::lowest());
}

TEST(ToYaml, ConvertsATreeThatTheAccessPointReaderTakes) {
  XmlRpcValue tree;
  tree["access_points"][0] = accessPoint("02:00:00:00:00:01", 1, 2.5);
  tree["access_points"][1] = accessPoint("02:00:00:00:00:02", -0.1, 3);
  tree["access_points"][1]["name"] = "study";

  const std::vector<AccessPoint> table =
      accessPointsFromYaml(toYaml(tree)["access_points"]).access_points;

  ASSERT_EQ(table.size(), 2U);
  EXPECT_EQ(table[0].position, Position(1.0, 2.5));
  EXPECT_EQ(table[1].position, Position(-0.1, 3.0));
  EXPECT_EQ(table[1].name, "study");
}

TEST(ToYaml, ConvertsEmptyLists) {
  XmlRpcValue list;
  list.setSize(0);
  EXPECT_TRUE(toYaml(list).IsSequence());
  EXPECT_EQ(toYaml(list).size(), 0U);
}

TEST(ToYaml, NamesWhatItCannotConvert) {
  char bytes[] = {1, 2, 3};
  XmlRpcValue tree;
  tree["access_points"][0] = accessPoint("02:00:00:00:00:01", XmlRpcValue(bytes, 3), 0);
  try {
    toYaml(tree);
    FAIL() << "binary was converted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "access_points[0]/x must not be a date or binary");
  }
}

}  // namespace
}  // namespace sfw
