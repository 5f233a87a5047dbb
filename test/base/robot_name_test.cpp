#include "structure_from_wifi/robot_name.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace sfw {
namespace {

TEST(RobotName, ComparesAsItsText) {
  const RobotName none;
  const RobotName a = "a";
  const RobotName b = std::string("b");
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none, RobotName(""));
  EXPECT_EQ(a, RobotName(std::string("a")));
  EXPECT_NE(a, b);
  EXPECT_TRUE(none < a && a < b);
  EXPECT_FALSE(a < none || b < a || a < a);
}

TEST(RobotName, ConvertsToItsText) {
  const std::string long_text(100, 'x');
  const RobotName name = long_text;
  const std::string& text = name;
  EXPECT_EQ(text, long_text);
  EXPECT_EQ(RobotName().str(), "");
}

TEST(RobotName, IsMadeByThreadsAtTheSameTime) {
  constexpr std::size_t kThreads = 4;
  constexpr int kNames = 500;
  std::vector<std::vector<RobotName>> names(kThreads);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      for (int name = 0; name < kNames; ++name) {
        names[i].emplace_back("robot of threads " + std::to_string(name));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (std::size_t i = 1; i < kThreads; ++i) {
    EXPECT_EQ(names[i], names[0]);
  }
  EXPECT_EQ(names[0][17].str(), "robot of threads 17");
}

}  // namespace
}  // namespace sfw
