#include "ros/conversion/message_layout.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "ros/conversion/input_messages.h"
#include "ros/conversion/message_values.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

/// Writes values as ROS serializes them.
class Bytes {
 public:
  template <class Value>
  Bytes& add(Value value) {
    const std::size_t size = bytes.size();
    bytes.resize(size + sizeof value);
    std::memcpy(bytes.data() + size, &value, sizeof value);
    return *this;
  }

  Bytes& text(const std::string& value) {
    add(static_cast<std::uint32_t>(value.size()));
    bytes.insert(bytes.end(), value.begin(), value.end());
    return *this;
  }

  std::vector<std::uint8_t> bytes;
};

const std::string kLine(80, '=');

std::string section(const std::string& type, const std::string& text) {
  return kLine + "\nMSG: " + type + "\n" + text + "\n";
}

Json read(const std::string& definition, const std::vector<std::uint8_t>& bytes,
          const std::set<std::string>& wanted) {
  return readValues(MessageLayout("my/Type", definition), bytes, wanted);
}

std::string errorOf(const std::string& definition, const std::vector<std::uint8_t>& bytes = {}) {
  try {
    read(definition, bytes, {"a", "b", "c"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(MessageLayout, ReadsEveryTypeOfField) {
  const std::string definition =
      "bool a\nint8 b\nuint8 c\nint16 d\nuint16 e\nint32 f\nuint32 g\nint64 h\nuint64 i\n"
      "float32 j\nfloat64 k\nstring l\ntime m\nduration n\nbyte o\nchar p\n";
  Bytes bytes;
  bytes.add<std::uint8_t>(1).add<std::int8_t>(-2).add<std::uint8_t>(200);
  bytes.add<std::int16_t>(-300).add<std::uint16_t>(60000).add<std::int32_t>(-70000);
  bytes.add<std::uint32_t>(4000000000).add<std::int64_t>(-5000000000).add(~std::uint64_t{0});
  bytes.add(0.5F).add(-0.25).text("six").add<std::uint32_t>(7).add<std::uint32_t>(8);
  bytes.add<std::int32_t>(-9).add<std::int32_t>(10).add<std::int8_t>(-11).add<std::uint8_t>(12);
  const std::set<std::string> all = {"a", "b", "c", "d", "e", "f", "g", "h",
                                     "i", "j", "k", "l", "m", "n", "o", "p"};
  EXPECT_EQ(read(definition, bytes.bytes, all),
            Json::parse(R"({"a": true, "b": -2, "c": 200, "d": -300, "e": 60000, "f": -70000,
              "g": 4000000000, "h": -5000000000, "i": 18446744073709551615, "j": 0.5, "k": -0.25,
              "l": "six", "m": {"secs": 7, "nsecs": 8}, "n": {"secs": -9, "nsecs": 10}, "o": -11,
              "p": 12})"));
}

TEST(MessageLayout, PassesOverCommentsAndConstants) {
  const std::string definition =
      "# a comment with = and int8 x\n  \nint8 KEY=3\nstring NAME= a # no comment\n"
      "int8 a # = 5\r\n\tint8   b\t# last\n";
  EXPECT_EQ(read(definition, {1, 2}, {"a", "b"}), Json::parse(R"({"a": 1, "b": 2})"));
}

TEST(MessageLayout, ReadsArraysInsideOfArrays) {
  const std::string definition = "Part[] a\nother/Part[2] b\n" +
                                 section("my/Part", "int8[] c\nuint8[2] d") +
                                 section("other/Part", "my/Part[1] c");
  Bytes bytes;
  bytes.add<std::uint32_t>(1).add<std::uint32_t>(2).add<std::int8_t>(-1).add<std::int8_t>(-2);
  bytes.add<std::uint16_t>(0x0201);
  for (std::uint16_t i = 0; i < 2; ++i) {
    bytes.add<std::uint32_t>(0).add<std::uint16_t>(i);
  }
  EXPECT_EQ(read(definition, bytes.bytes, {"a", "b", "c", "d"}), Json::parse(R"({
      "a": [{"c": [-1, -2], "d": [1, 2]}],
      "b": [{"c": [{"c": [], "d": [0, 0]}]}, {"c": [{"c": [], "d": [1, 0]}]}]})"));
}

TEST(MessageLayout, LeavesOutFieldsThatAreNotWanted) {
  Bytes bytes;
  bytes.text("long").add<std::uint32_t>(1).add(0.5).add<std::int8_t>(4);
  EXPECT_EQ(read("string a\nfloat64[] b\nint8 c\n", bytes.bytes, {"c"}),
            Json::parse(R"({"c": 4})"));
}

TEST(MessageLayout, RefusesBytesThatDoNotFit) {
  Bytes text;
  text.text("abc");
  EXPECT_EQ(errorOf("string a", text.bytes), "");
  text.bytes.pop_back();
  EXPECT_NE(errorOf("string a", text.bytes), "");
  EXPECT_NE(errorOf("int32 a", {1, 2, 3}), "");
  EXPECT_EQ(errorOf("int8 a", {1, 2}), "a message has 1 bytes too many");
  EXPECT_NE(errorOf("Part[] a\n" + section("my/Part", "string b"), {0xff, 0xff, 0xff, 0xff}), "");
}

TEST(MessageLayout, RefusesDefinitionsThatCannotBe) {
  for (const std::string& definition :
       {std::string("int8"), std::string("int8 a b"), std::string("Lost a"),
        std::string("int8[x] a"), std::string("int8[-1] a"), std::string("int8[99999999999] a"),
        std::string("int8[2 a"), std::string(300000, '#'),
        "Part a\n" + section("my/Part", "Part b"),
        "Part a\n" + section("my/Part", "Whole b") + section("my/Whole", "Part c")}) {
    EXPECT_NE(errorOf(definition, {0}), "") << definition.substr(0, 40);
  }
  std::string types = "int8 a\n";
  for (int i = 0; i < 65; ++i) {
    types += section("my/T" + std::to_string(i), "");
  }
  EXPECT_NE(errorOf(types, {0}), "");
}

TEST(MessageLayout, SpendsNoTimeOnElementsWithoutBytes) {
  std::string nested = "T0[4000000000] a\nT0[] b\n";
  for (int i = 0; i < 20; ++i) {
    nested += section("my/T" + std::to_string(i), "T" + std::to_string(i + 1) + "[4000000000] c");
  }
  nested += section("my/T20", "");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(errorOf(nested, {0xff, 0xff, 0xff, 0xff}), "");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

/// A message of each kind that the converter treats in its own way.
std::vector<AnyMessage> seeds() {
  const std::string header = section("std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id");
  Bytes scan;
  scan.add<std::uint32_t>(0).add<std::uint32_t>(99).add<std::uint32_t>(0).text("antenna");
  scan.add<std::uint32_t>(2);
  for (const char* bssid : {"02:00:00:00:00:01", "02:00:00:00:00:02"}) {
    scan.text(bssid).text("name").add(-50.0F).add(2412.0F).add(0.5F);
  }
  Bytes rss;
  rss.add(std::uint64_t{99000000000}).add<std::uint32_t>(500);
  rss.add<std::uint32_t>(1).text("02:00:00:00:00:01").add<std::uint32_t>(1).add<std::int16_t>(2412);
  rss.add<std::uint32_t>(1).add<std::uint32_t>(2).add<std::int8_t>(-50).add<std::int8_t>(-52);
  Bytes text;
  text.text(R"({"timestamp": 99.5, "data": [{"type": "WiFi", "mac": "02:00:00:00:00:01",
      "rssi": -50, "last_seen_ms": 200}, {"mac": [2, 0, 0, 0, 0, 1], "rssi": "-50"}]})");
  return {{"structure_from_wifi/WifiScan", "",
           "Header header\nApReading[] readings\n" + header +
               section("structure_from_wifi/ApReading",
                       "string bssid # address\nstring ssid\nfloat32 rssi_dbm\n"
                       "float32 frequency_mhz\nfloat32 age_s"),
           scan.bytes},
          {"rss/RssData", "",
           "uint64 time_start_ns\nuint32 duration_ms\nstring[] mac_address\nint16[] freq\n"
           "RssDatum[] data\n" +
               section("rss/RssDatum", "int8[] rss"),
           rss.bytes},
          {"std_msgs/String", "", "string data\n", text.bytes}};
}

template <class Text>
void mutate(Text& text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::size_t at = below(text.size());
  switch (random() % 5) {
    case 0:
      text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin(),
                  text.begin() + static_cast<std::ptrdiff_t>(below(text.size())));
      break;
    case 1:
      text.erase(text.begin() + static_cast<std::ptrdiff_t>(at),
                 text.begin() + static_cast<std::ptrdiff_t>(at + below(text.size() - at)));
      break;
    case 2:
      text.resize(at);
      break;
    default:
      if (!text.empty()) {
        text[at] = static_cast<typename Text::value_type>(random() % 3 == 0 ? 0xff : random());
      }
  }
  text.resize(std::min<std::size_t>(text.size(), 4000));
}

TEST(MessageLayout, SurvivesMutatedDefinitionsAndBytes) {
  constexpr int kMutations = 100000;
  std::mt19937 random(14);
  const std::vector<AnyMessage> originals = seeds();
  std::size_t readings = 0, refused = 0;
  for (int i = 0; i < kMutations; ++i) {
    AnyMessage message = originals[random() % originals.size()];
    for (std::size_t n = 1 + random() % 3; n > 0; --n) {
      random() % 2 == 0 ? mutate(message.bytes, random) : mutate(message.definition, random);
    }
    const Conversion conversion = convertReadings(message, {ros::Time(100.0), "antenna", 0.2});
    readings += conversion.observations.size();
    refused += conversion.problem.empty() ? 0 : 1;
  }
  EXPECT_GT(readings, 1000U);  // the mutations are not too wild
  EXPECT_GT(refused, 1000U);
}

TEST(MessageLayout, TakesSoManyReadingsOfAHugeScan) {
  const AnyMessage one = seeds()[0];
  AnyMessage many = one;
  constexpr std::uint32_t kReadings = 2 * kMostReadings;
  constexpr std::size_t kCount = 12 + 4 + 7;  // where the number of readings stands
  const std::vector<std::uint8_t> reading(
      one.bytes.end() - static_cast<std::ptrdiff_t>((one.bytes.size() - kCount - 4) / 2),
      one.bytes.end());
  many.bytes.resize(kCount + 4);
  std::memcpy(many.bytes.data() + kCount, &kReadings, 4);
  for (std::uint32_t i = 0; i < kReadings; ++i) {
    many.bytes.insert(many.bytes.end(), reading.begin(), reading.end());
  }
  const std::clock_t start = std::clock();  // of this process alone
  const Conversion conversion = convertReadings(many, {ros::Time(100.0), "antenna", 0.2});
  const double elapsed_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_EQ(conversion.observations.size(), kMostReadings);
  EXPECT_EQ(conversion.rejected.at("the message has more than 10000 readings"), kMostReadings);
  std::printf("%u readings took %.0f ms\n", kReadings, 1e3 * elapsed_s);
}

}  // namespace
}  // namespace sfw
