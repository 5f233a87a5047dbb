#include <gtest/gtest.h>

#include "structure_from_wifi/types.h"

namespace sfw {
namespace {

/// The canonical form of what is read; empty if nothing is.
std::string read(std::string_view text) {
  const std::optional<Bssid> bssid = Bssid::parse(text);
  return bssid ? bssid->str() : "";
}

TEST(Bssid, IsReadInEitherCaseAndWithEitherSeparator) {
  EXPECT_EQ(read("01:23:45:67:89:ab"), "01:23:45:67:89:ab");
  EXPECT_EQ(read("CD:EF:0A:1B:2C:3D"), "cd:ef:0a:1b:2c:3d");
  EXPECT_EQ(read("cD-Ef-0a-1B-2c-3D"), "cd:ef:0a:1b:2c:3d");
  EXPECT_EQ(read("ff:ff:ff:ff:ff:ff"), "ff:ff:ff:ff:ff:ff");
  EXPECT_EQ(read("00:00:00:00:00:01"), "00:00:00:00:00:01");
}

TEST(Bssid, IsReadAsNetworkDevicesWriteIt) {
  for (const char* const text : {"0123.4567.89AB", "0123456789ab", "012345-6789ab"}) {
    EXPECT_EQ(read(text), "01:23:45:67:89:ab") << text;
  }
  EXPECT_EQ(read("525400123456"), "52:54:00:12:34:56");
}

TEST(Bssid, IsNothingWhenMalformed) {
  for (const char* const text :
       {"0123.4567.89a", "0123.4567", "0123.45678.9ab", "0123456789a", "0123456789abc",
        "012345:6789ab", "01234-56789ab", "...", "0123.4567.89ab."}) {
    EXPECT_EQ(read(text), "") << text;
  }

  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read("01:23:45:67:89:a"), "");
  EXPECT_EQ(read("01:23:45:67:89:ab:"), "");
  EXPECT_EQ(read("01:23:45:67:89:ag"), "");
  EXPECT_EQ(read("01.23.45.67.89.ab"), "");
  EXPECT_EQ(read("0123456789ab00000"), "");
  EXPECT_EQ(read("0:123:45:67:89:ab"), "");
  EXPECT_EQ(read(" 01:23:45:67:89:a"), "");
  EXPECT_EQ(read("+1:23:45:67:89:ab"), "");
  EXPECT_EQ(read("01:23:45:67:89:\xc3\xa4"), "");
  EXPECT_EQ(read(std::string_view("\0\0:00:00:00:00:01", 17)), "");
}

TEST(Bssid, IsNothingWhenTheRadioIsNotAssociated) {
  EXPECT_EQ(read("00:00:00:00:00:00"), "");
  EXPECT_EQ(read("00-00-00-00-00-00"), "");
}

TEST(Bssid, IsRelatedToTheAddressesOfItsRadio) {
  const auto related = [](const char* a, const char* b) {
    return Bssid::parse(a)->isRelatedTo(*Bssid::parse(b));
  };
  EXPECT_TRUE(related("a0:00:00:00:00:47", "a0:00:00:00:00:40"));
  EXPECT_TRUE(related("a0:00:00:00:00:40", "a2:00:00:00:00:4f"));
  EXPECT_TRUE(related("a0:00:00:00:00:3f", "a0:00:00:00:00:4e"));
  EXPECT_FALSE(related("a0:00:00:00:00:3f", "a0:00:00:00:00:4f"));
  EXPECT_FALSE(related("a0:00:00:00:01:40", "a0:00:00:00:00:40"));
  EXPECT_FALSE(related("a0:01:00:00:00:40", "a0:00:00:00:00:40"));
}

TEST(Bssid, IsOrderedAsItIsWritten) {
  const Bssid low = *Bssid::parse("00:00:00:00:00:ff");
  const Bssid high = *Bssid::parse("00:00:00:00:01:00");
  EXPECT_LT(low, high);
  EXPECT_FALSE(high < low);
  EXPECT_NE(low, high);
  EXPECT_EQ(high, *Bssid::parse("00-00-00-00-01-00"));
}

}  // namespace
}  // namespace sfw
