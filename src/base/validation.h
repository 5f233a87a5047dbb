#pragma once

#include <cstdint>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

namespace sfw {

/// Throws the problems of settings or of input, one in each line.
/// @throw InputError unless there is no problem.
void throwIfAny(const std::vector<std::string>& problems);

/// Collects every problem of settings, so that a user sees all of them at once.
///
/// Each problem is one sentence that starts with the setting's name and ends with its value. NaN
/// breaks every rule on numbers.
class Problems {
 public:
  /// Adds "NAME must be RULE; it is VALUE" unless the rule holds.
  template <class T>
  void require(bool holds, const std::string& name, const T& value, const std::string& rule) {
    if (!holds) {
      std::ostringstream text;
      text << name << " must be " << rule << "; it is " << value;
      add(text.str());
    }
  }

  /// Requires a value between two limits, both included.
  /// @param unit  of the limits, for the sentence; may be empty
  void within(const std::string& name, double value, double low, double high,
              const std::string& unit = "");

  /// Requires a finite number above 0.
  void positive(const std::string& name, double value);

  /// Requires a finite number of at least 0.
  void notNegative(const std::string& name, double value);

  void atLeast(const std::string& name, std::int64_t value, std::int64_t least);

  /// Requires a value between 0 and 1, both excluded.
  void probability(const std::string& name, double value);

  /// Requires one of a few words.
  void oneOf(const std::string& name, const std::string& value,
             std::initializer_list<const char*> allowed);

  /// Requires the name of a tf frame, without a leading slash.
  void frame(const std::string& name, const std::string& value);

  void add(const std::string& problem) { problems_.push_back(problem); }

  /// Adds the problems of a part of the settings, with a prefix to their names.
  void add(const std::vector<std::string>& problems, const std::string& prefix = "");

  const std::vector<std::string>& list() const { return problems_; }

  /// @throw InputError if any problem was added, one in each line.
  void throwIfAny() const { sfw::throwIfAny(problems_); }

 private:
  std::vector<std::string> problems_;
};

}  // namespace sfw
