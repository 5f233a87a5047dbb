#include "base/validation.h"

#include <cmath>

#include "structure_from_wifi/input_error.h"

namespace sfw {

void throwIfAny(const std::vector<std::string>& problems) {
  std::string text;
  for (const std::string& problem : problems) {
    text += (text.empty() ? "" : "\n") + problem;
  }
  if (!text.empty()) {
    throw InputError(text);
  }
}

void Problems::within(const std::string& name, double value, double low, double high,
                      const std::string& unit) {
  if (!(value >= low && value <= high)) {
    std::ostringstream text;
    text << name << " must lie in " << low << ".." << high << (unit.empty() ? "" : " ") << unit
         << "; it is " << value;
    add(text.str());
  }
}

void Problems::positive(const std::string& name, double value) {
  require(std::isfinite(value) && value > 0.0, name, value, "finite and positive");
}

void Problems::notNegative(const std::string& name, double value) {
  require(std::isfinite(value) && value >= 0.0, name, value, "finite and not negative");
}

void Problems::atLeast(const std::string& name, std::int64_t value, std::int64_t least) {
  require(value >= least, name, value, "at least " + std::to_string(least));
}

void Problems::probability(const std::string& name, double value) {
  require(value > 0.0 && value < 1.0, name, value, "between 0 and 1, both excluded");
}

void Problems::oneOf(const std::string& name, const std::string& value,
                     std::initializer_list<const char*> allowed) {
  std::string rule;
  bool holds = false;
  for (const char* const* word = allowed.begin(); word != allowed.end(); ++word) {
    holds = holds || value == *word;
    const bool is_last = word + 1 == allowed.end();
    rule += (word == allowed.begin() ? "" : is_last ? " or " : ", ") + std::string(*word);
  }
  require(holds, name, "'" + value + "'", rule);
}

void Problems::frame(const std::string& name, const std::string& value) {
  require(!value.empty() && value.front() != '/', name, "'" + value + "'",
          "a frame's name without a leading slash");
}

void Problems::add(const std::vector<std::string>& problems, const std::string& prefix) {
  for (const std::string& problem : problems) {
    add(prefix + problem);
  }
}

}  // namespace sfw
