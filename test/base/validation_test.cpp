#include "base/validation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Texts = std::vector<std::string>;

TEST(Problems, AreNoneWhileEveryRuleHolds) {
  Problems problems;
  problems.within("speed", 1.0, 1.0, 2.0);
  problems.within("speed", 2.0, 1.0, 2.0);
  problems.positive("size", 0.1);
  problems.notNegative("weight", 0.0);
  problems.atLeast("count", 1, 1);
  problems.probability("prior", 0.5);
  problems.frame("map_frame", "map");
  problems.oneOf("mode", "scan", {"link", "cache", "scan"});
  problems.require(true, "window", 4, "odd");
  EXPECT_EQ(problems.list(), Texts());
  EXPECT_NO_THROW(problems.throwIfAny());
}

TEST(Problems, NameTheSettingTheRuleAndTheValue) {
  Problems problems;
  problems.within("speed", 2.5, 1.0, 2.0, "m/s");
  problems.within("area", 0.5, 1.0, 2.0);
  problems.positive("size", 0.0);
  problems.notNegative("weight", -1.0);
  problems.atLeast("count", 0, 1);
  problems.probability("prior", 1.0);
  problems.frame("map_frame", "/map");
  problems.oneOf("mode", "loud", {"link", "cache", "scan"});
  problems.oneOf("filter", "", {"median", "mean"});
  problems.require(false, "window", 4, "odd");
  EXPECT_EQ(problems.list(),
            (Texts{"speed must lie in 1..2 m/s; it is 2.5", "area must lie in 1..2; it is 0.5",
                   "size must be finite and positive; it is 0",
                   "weight must be finite and not negative; it is -1",
                   "count must be at least 1; it is 0",
                   "prior must be between 0 and 1, both excluded; it is 1",
                   "map_frame must be a frame's name without a leading slash; it is '/map'",
                   "mode must be link, cache or scan; it is 'loud'",
                   "filter must be median or mean; it is ''", "window must be odd; it is 4"}));
}

TEST(Problems, RefuseNotANumberAndInfinity) {
  Problems problems;
  problems.within("a", std::nan(""), 1.0, 2.0);
  problems.positive("b", std::nan(""));
  problems.positive("c", HUGE_VAL);
  problems.notNegative("d", std::nan(""));
  problems.probability("e", std::nan(""));
  EXPECT_EQ(problems.list().size(), 5U);
}

TEST(Problems, AreThrownOneInEachLine) {
  Problems problems;
  problems.add("a is wrong");
  problems.add({"b is wrong", "c is wrong"}, "radio/");
  try {
    problems.throwIfAny();
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a is wrong\nradio/b is wrong\nradio/c is wrong");
  }
}

}  // namespace
}  // namespace sfw
