#include "walls/wall_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>

#include "structure_from_wifi/input_error.h"
#include "walls/network_inputs.h"

namespace sfw::test {
namespace {

/// A layer of one channel out of some, that copies the last of them.
std::string layer(std::size_t inputs, const std::string& bias = "0") {
  std::string weights;
  for (std::size_t i = 0; i < inputs; ++i) {
    weights += std::string(i == 0 ? "" : ", ") + (i + 1 == inputs ? "1" : "0");
  }
  return "{\"edge\": 1, \"weights\": [" + weights + "], \"bias\": [" + bias + "]}";
}

/// A network of one channel. Its finest level copies the input to the output, plus 0, 1, 2 and 3.
std::string copyingNetwork(const std::string& format = "1") {
  std::string layers = layer(1);
  for (int i = 1; i < 8; ++i) {
    layers += ", " + layer(1);
  }
  for (int i = 0; i < 3; ++i) {
    layers += ", " + layer(2);  // copies the finer level
  }
  layers += R"(, {"edge": 1, "weights": [1, 1, 1, 1], "bias": [0, 1, 2, 3]})";
  return "{\"format\": " + format + ", \"inputs\": [\"a\"], \"layers\": [" + layers + "]}";
}

std::string errorOf(const std::string& json) {
  try {
    parseWallNetwork(json, "net.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(WallNetwork, KeepsTheSizeOfRastersOfAnySize) {
  const WallNetwork network = parseWallNetwork(copyingNetwork(), "net.json");
  Channels input(1, 3, 13);
  for (std::size_t i = 0; i < input.values().size(); ++i) {
    input.values()[i] = static_cast<float>(i);
  }
  const Channels output = network.apply(rowsOf(input), std::atomic<bool>(false));
  ASSERT_EQ(output.count(), 4U);
  ASSERT_EQ(output.height(), 3U);
  ASSERT_EQ(output.width(), 13U);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    EXPECT_EQ(output.row(channel, 2)[12], 38.0F + static_cast<float>(channel));
  }
}

TEST(WallNetwork, NamesWhatIsWrongInAFile) {
  const std::string good = copyingNetwork();
  EXPECT_EQ(errorOf(good), "no error");
  EXPECT_NE(errorOf("{").find("net.json: not a network of walls"), std::string::npos);
  EXPECT_NE(errorOf(replaced(good, "inputs", "input")).find("inputs"), std::string::npos);
  EXPECT_NE(errorOf(copyingNetwork("2")).find("another format"), std::string::npos);
  EXPECT_NE(
      errorOf(replaced(good, R"(, {"edge": 1, "weights": [1, 1, 1, 1], "bias": [0, 1, 2, 3]})", ""))
          .find("layers must be a list of 12 layers"),
      std::string::npos);
  EXPECT_NE(errorOf(replaced(good, "[\"a\"]", "[\"a\", \"b\"]")).find("do not fit each other"),
            std::string::npos);
}

TEST(WallNetwork, AFileMaySayHowItWasMade) {
  const std::string made = replaced(copyingNetwork(), "{", "{\"made_by\": {\"seed\": 1}, ");
  EXPECT_EQ(errorOf(made), "no error");
}

TEST(WallNetwork, WithoutRadioOnlyKnownInputsAreLeftOut) {
  const std::vector<std::string> all = networkInputNames();
  const std::vector<std::string> radio = networkRadioInputNames();
  EXPECT_LT(radio.size(), all.size());
  for (const std::string& name : radio) {
    EXPECT_EQ(std::count(all.begin(), all.end(), name), 1) << name;
  }
}

TEST(WallNetwork, TheShippedOneSeesTheInputsThatTheMapperMakes) {
  EXPECT_EQ(shippedWallNetwork().inputs(), networkInputNames());
}

}  // namespace
}  // namespace sfw::test
