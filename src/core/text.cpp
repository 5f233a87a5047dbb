#include "text.h"

#include <clocale>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "structure_from_wifi/input_error.h"

namespace sfw {

std::optional<double> parseNumber(std::string_view text) {
  static const locale_t kClassic = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string number(trimmed(text));
  char* end = nullptr;
  const double value = strtod_l(number.c_str(), &end, kClassic);
  if (number.empty() || end != number.c_str() + number.size()) {
    return std::nullopt;
  }
  return value;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(at + 1);
  }
}

std::string readFile(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  if (stream) {
    errno = 0;
    text.assign(std::istreambuf_iterator<char>(stream), {});
  }
  if (!stream || errno != 0) {  // a directory opens, but does not read
    throw InputError(file + ": cannot be read: " + std::strerror(errno));
  }
  return text;
}

}  // namespace sfw
