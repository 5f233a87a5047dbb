// Runs a target on mutations of its valid inputs, the same ones each time. Any compiler can build
// it; scripts/fuzz uses libFuzzer, which sees what an input reaches and so goes deeper.
//
// SFW_FUZZ_SECONDS runs further mutations for so long.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <random>

#include "fuzz_target.h"
#include "support/slowdown.h"

namespace sfw::fuzz {
namespace {

using Random = std::mt19937_64;

std::size_t below(std::size_t limit, Random& random) { return limit == 0 ? 0 : random() % limit; }

const std::string& anyOf(const std::vector<std::string>& texts, Random& random) {
  return texts[below(texts.size(), random)];
}

/// Changes one place of an input.
void mutate(std::string& input, const std::vector<std::string>& seeds, Random& random) {
  static const std::vector<std::string> hostile{"nan",
                                                "-inf",
                                                "1e999",
                                                "-0",
                                                "4294967296",
                                                "-9223372036854775808",
                                                "18446744073709551616",
                                                "\n",
                                                ",",
                                                ";",
                                                "\"",
                                                "'",
                                                "[[[[",
                                                "{",
                                                ": ",
                                                "&a",
                                                "*a",
                                                "#",
                                                "\xff",
                                                "\xef\xbb\xbf",
                                                std::string(4, '\0'),
                                                std::string(4, '\xff'),
                                                std::string("\0\0\300\177", 4),
                                                std::string("\0\0\200\177", 4)};
  const std::size_t at = below(input.size() + 1, random);
  const std::size_t length = below(std::min<std::size_t>(input.size() - at, 40) + 1, random);
  switch (below(6, random)) {
    case 0:
      input.erase(at, length);
      break;
    case 1:
      input.insert(at, input.substr(at, length));
      break;
    case 2:
      input.replace(at, length, anyOf(hostile, random));
      break;
    case 3:
      input.insert(at, anyOf(hostile, random));
      break;
    case 4: {
      const std::string& other = anyOf(seeds, random);
      input.replace(at, length, other.substr(below(other.size(), random), length));
      break;
    }
    default:
      if (at < input.size()) {
        input[at] = static_cast<char>(random());
      }
  }
}

std::string mutation(const std::vector<std::string>& seeds, Random& random) {
  std::string input = anyOf(seeds, random);
  for (std::size_t left = 1 + below(8, random); left > 0; --left) {
    mutate(input, seeds, random);
  }
  return input;
}

TEST(Fuzz, SurvivesMutationsOfValidInputs) {
  const std::vector<std::string> valid = seeds();
  for (const std::string& input : valid) {
    feed(input);
  }
  feed("");
  const char* seconds = std::getenv("SFW_FUZZ_SECONDS");
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::seconds(seconds == nullptr ? 0 : std::atoi(seconds));
  const int least = static_cast<int>(20'000 / kSlowdown);
  Random random(1);
  int runs = 0;
  for (; runs < least || std::chrono::steady_clock::now() < end; ++runs) {
    const std::string input = mutation(valid, random);
    ASSERT_NO_THROW(feed(input)) << "input " << runs << ": " << testing::PrintToString(input);
  }
  RecordProperty("runs", runs);
}

}  // namespace
}  // namespace sfw::fuzz
