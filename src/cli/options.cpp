#include "cli/options.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <sstream>

#include "base/old_name.h"
#include "cli/warnings.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace po = boost::program_options;

constexpr unsigned kLineLength = 100;
constexpr unsigned kTextLength = 60;

[[noreturn]] void refuse(const std::string& name, const std::string& expected,
                         const std::string& text) {
  throw InputError("--" + name + " must be " + expected + "; it is '" + text + "'");
}

}  // namespace

void readOption(const std::string& /*name*/, const std::string& text, std::string& value) {
  value = text;
}

void readOption(const std::string& name, const std::string& text, double& value) {
  const std::optional<double> number = parseNumber(text);
  if (!number) {
    refuse(name, "a number", text);
  }
  value = *number;
}

void readOption(const std::string& name, const std::string& text, std::int64_t& value) {
  const char* const end = text.data() + text.size();
  std::int64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) {
    refuse(name, "a whole number", text);
  }
  value = number;
}

void readOption(const std::string& name, const std::string& text,
                std::optional<std::int64_t>& value) {
  std::int64_t number = 0;
  readOption(name, text, number);
  value = number;
}

std::string defaultText(const std::string& value) {
  return value.empty() ? "" : "; default: " + value;
}

std::string defaultText(double value) {
  std::ostringstream text;
  text << "; default: " << value;
  return text.str();
}

std::string defaultText(std::int64_t value) { return "; default: " + std::to_string(value); }

std::string defaultText(const std::optional<std::int64_t>& value) {
  return value ? defaultText(*value) : "";
}

Options::Options(std::string command, std::string purpose, std::vector<std::string> arguments)
    : command_(std::move(command)),
      purpose_(std::move(purpose)),
      arguments_(std::move(arguments)),
      description_("Options", kLineLength, kTextLength) {
  description_.add_options()("help", "print this help and exit");
}

void Options::addValue(const std::string& name, const std::string& placeholder,
                       const std::string& text, std::function<void(const std::string&)> read) {
  description_.add_options()(
      name.c_str(), po::value<std::string>()->value_name(placeholder)->notifier(std::move(read)),
      text.c_str());
}

void Options::addInRange(const std::string& name, std::int64_t& value, std::int64_t low,
                         std::int64_t high, const std::string& text) {
  const std::string range = std::to_string(low) + ".." + std::to_string(high);
  addValue(name, "N", text + ", in " + range + defaultText(value),
           [=, &value](const std::string& given) {
             std::int64_t number = 0;
             readOption(name, given, number);
             if (number < low || number > high) {
               refuse(name, "in " + range, given);
             }
             value = number;
           });
}

void Options::addRequired(const std::string& name, const std::string& placeholder,
                          std::string& value, const std::string& text) {
  add(name, placeholder, value, text + "; required");
  require(name);
}

void Options::addList(const std::string& name, const std::string& placeholder,
                      std::vector<std::string>& values, const std::string& text) {
  description_.add_options()(
      name.c_str(),
      po::value<std::vector<std::string>>(&values)->value_name(placeholder)->multitoken(),
      (text + "; may be repeated").c_str());
}

void Options::addFlag(const std::string& name, bool& value, const std::string& text) {
  description_.add_options()(name.c_str(), po::value<bool>(&value)->zero_tokens(), text.c_str());
}

void Options::addOldName(const std::string& old_name, const std::string& name) {
  new_names_["--" + old_name] = "--" + name;
}

void Options::replaceOldNames() {
  for (std::string& argument : arguments_) {
    const std::size_t end = std::min(argument.find('='), argument.size());
    const auto found = new_names_.find(argument.substr(0, end));
    if (found != new_names_.end()) {
      warn("sfw " + command_ + ": " + oldNameWarning(found->first, found->second));
      argument = found->second + argument.substr(end);
    }
  }
}

std::string Options::nearestName(const std::string& unknown) const {
  std::string nearest;
  std::size_t least = std::string::npos;
  for (const auto& option : description_.options()) {
    const std::string name = "--" + option->long_name();
    const std::size_t distance = editDistance(unknown, name);
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  return nearest;
}

void Options::readValues() {
  namespace style = po::command_line_style;
  // There are no short options, so a value may start with a minus sign: --access-point -1.5,2.
  const auto parsed =
      po::command_line_parser(arguments_)
          .options(description_)
          .style(style::allow_long | style::long_allow_adjacent | style::long_allow_next)
          .run();
  for (const auto& option : parsed.options) {
    if (option.string_key.empty()) {
      throw InputError("'" + option.value.front() + "' belongs to no option");
    }
  }
  po::store(parsed, values_);
  if (given("help")) {
    return;
  }
  for (const std::string& name : required_) {
    if (!given(name)) {
      throw InputError("--" + name + " is missing");
    }
  }
  po::notify(values_);
}

bool Options::parse() {
  replaceOldNames();
  std::replace(arguments_.begin(), arguments_.end(), std::string("-h"), std::string("--help"));
  const std::string see_help = "; see `sfw " + command_ + " --help`";
  try {
    readValues();
  } catch (const po::unknown_option& error) {
    throw InputError("there is no option " + error.get_option_name() + "; did you mean " +
                     nearestName(error.get_option_name()) + "?" + see_help);
  } catch (const po::error& error) {
    throw InputError(error.what() + see_help);
  } catch (const InputError& error) {
    throw InputError(error.what() + see_help);
  }
  if (given("help")) {
    std::cout << "Usage: sfw " << command_ << " OPTIONS\n\n" << purpose_ << "\n\n" << description_;
    return false;
  }
  return true;
}

}  // namespace sfw
