#include "base/erase_if.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sfw {
namespace {

TEST(EraseIf, KeepsTheOtherElementsWholeAndInOrder) {
  const std::string text = "too long for the buffer inside a string";
  std::vector<std::string> all{text + "a", "", text + "b", text + "c", ""};
  eraseIf(all, [](const std::string& one) { return one.empty(); });
  EXPECT_EQ(all, (std::vector<std::string>{text + "a", text + "b", text + "c"}));
}

TEST(EraseIf, AsksOnceForEachElementInOrder) {
  std::vector<int> all{3, 1, 2};
  std::vector<int> asked;
  eraseIf(all, [&](int one) {
    asked.push_back(one);
    return true;
  });
  EXPECT_EQ(asked, (std::vector<int>{3, 1, 2}));
  EXPECT_TRUE(all.empty());
}

}  // namespace
}  // namespace sfw
