#pragma once

#include <boost/program_options.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sfw {

/// Reads the value of an option. Numbers use '.' as decimal point in any locale.
/// @throw InputError that names the option if the text is no such number
void readOption(const std::string& name, const std::string& text, std::string& value);
void readOption(const std::string& name, const std::string& text, double& value);
void readOption(const std::string& name, const std::string& text, std::int64_t& value);
void readOption(const std::string& name, const std::string& text,
                std::optional<std::int64_t>& value);

/// "; default: 0.05", or nothing for a value that has no default.
std::string defaultText(const std::string& value);
std::string defaultText(double value);
std::string defaultText(std::int64_t value);
std::string defaultText(const std::optional<std::int64_t>& value);

/// The options of one subcommand. Each is declared once, with its default and its help.
///
/// The command line gives a value as `--name value` or `--name=value`.
class Options {
 public:
  /// @param command    name of the subcommand
  /// @param purpose    what the subcommand does, for its help
  /// @param arguments  the command line after the name of the subcommand
  Options(std::string command, std::string purpose, std::vector<std::string> arguments);

  /// Declares an option. Its default is the value that the variable has now.
  /// @param placeholder  what the help shows for the value: "FILE", "METRES"
  template <class T>
  void add(const std::string& name, const std::string& placeholder, T& value,
           const std::string& text) {
    addValue(name, placeholder, text + defaultText(value),
             [name, &value](const std::string& given) { readOption(name, given, value); });
  }

  /// Declares an option for a whole number in low..high.
  void addInRange(const std::string& name, std::int64_t& value, std::int64_t low, std::int64_t high,
                  const std::string& text);

  /// Declares an option that must be given.
  void addRequired(const std::string& name, const std::string& placeholder, std::string& value,
                   const std::string& text);

  /// Makes a declared option required.
  void require(const std::string& name) { required_.push_back(name); }

  /// Declares an option that takes one or more values and may be repeated.
  void addList(const std::string& name, const std::string& placeholder,
               std::vector<std::string>& values, const std::string& text);

  /// Declares an option without a value.
  void addFlag(const std::string& name, bool& value, const std::string& text);

  /// Accepts an old name of an option, with a warning. Both names are without the leading `--`.
  void addOldName(const std::string& old_name, const std::string& name);

  /// Reads the command line into the variables, or prints the help if it asks for that.
  /// @return whether the subcommand is to run: false after the help
  /// @throw InputError that names the option and how to correct it
  bool parse();

  /// Whether the command line has the option. Call it only after parse().
  bool given(const std::string& name) const { return values_.count(name) != 0; }

 private:
  void addValue(const std::string& name, const std::string& placeholder, const std::string& text,
                std::function<void(const std::string&)> read);
  void replaceOldNames();
  void readValues();
  std::string nearestName(const std::string& unknown) const;

  std::string command_;
  std::string purpose_;
  std::vector<std::string> arguments_;
  std::vector<std::string> required_;
  std::map<std::string, std::string> new_names_;  // by the old name
  boost::program_options::options_description description_;
  boost::program_options::variables_map values_;
};

}  // namespace sfw
