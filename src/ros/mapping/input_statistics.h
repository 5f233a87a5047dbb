#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/conversion/observation.h"

namespace sfw {

/// Counts the messages of each input. Thread-safe; no function waits for more than a copy.
///
/// Times are seconds of a clock that never stands still.
class InputStatistics {
 public:
  /// The counts of an input.
  struct Input {
    std::string topic;      ///< its full name
    bool is_radio = false;  ///< it brings readings
    std::size_t messages = 0;
    std::size_t observations = 0;                 ///< readings and contacts that could be used
    std::map<std::string, std::size_t> rejected;  ///< readings left out, by reason
    std::string problem;                          ///< of the last message; empty if it had none
    double rate_hz = 0.0;                         ///< messages a second in the last 10 s
    std::optional<double> last_message_s;         ///< when it came
    std::optional<double> last_observation_s;     ///< when the last usable observation came
  };

  /// Adds an input.
  /// @return its index
  std::size_t add(const std::string& topic, bool is_radio);

  /// Counts a message and the result of its conversion.
  void count(std::size_t input, const Conversion& conversion, double now_s);

  /// The counts of all inputs.
  std::vector<Input> inputs(double now_s) const;

  /// Takes the counts of rejected readings since the last call, by reason.
  std::map<std::string, std::size_t> takeRejected();

 private:
  static constexpr std::int64_t kWindow = 10;  // [s]

  /// Messages of the last seconds, one counter a second.
  struct Recent {
    std::array<std::size_t, kWindow> counts{};
    std::int64_t last_second = 0;

    void moveTo(std::int64_t second);
  };

  mutable std::mutex mutex_;
  std::vector<Input> inputs_;
  std::vector<Recent> recent_;  // of each input
  std::map<std::string, std::size_t> rejected_;
};

}  // namespace sfw
