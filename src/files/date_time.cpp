#include "files/date_time.h"

#include <ctime>
#include <regex>
#include <string>

#include "files/text.h"

namespace sfw {
namespace {

const std::regex kForm(R"((\d{4})-(\d\d)-(\d\d)[ T](\d\d):(\d\d)(?::(\d\d)([.,]\d{1,9})?)?)"
                       R"(\s*(Z|UTC|[+-]\d\d:?\d\d)?)");

/// Whether the month has such a day, and the day such a time: a carry changes the fields.
bool isInCalendar(const std::tm& time, std::time_t seconds) {
  std::tm carried{};
  gmtime_r(&seconds, &carried);
  return carried.tm_mon == time.tm_mon && carried.tm_mday == time.tm_mday &&
         carried.tm_hour == time.tm_hour && carried.tm_min == time.tm_min &&
         carried.tm_sec == time.tm_sec;
}

}  // namespace

std::optional<std::int64_t> parseDateTime(std::string_view text) {
  const std::string plain(trimmed(text));
  std::smatch part;
  if (plain.size() < 16 || plain[4] != '-' || !std::regex_match(plain, part, kForm)) {
    return std::nullopt;
  }
  const auto number = [&](std::size_t i) { return part[i].matched ? std::stoi(part[i].str()) : 0; };
  std::tm time{};
  time.tm_year = number(1) - 1900;
  time.tm_mon = number(2) - 1;
  time.tm_mday = number(3);
  time.tm_hour = number(4);
  time.tm_min = number(5);
  time.tm_sec = number(6);
  const std::tm given = time;
  std::time_t seconds = timegm(&time);
  if (number(1) < 1970 || number(1) > 2099 || !isInCalendar(given, seconds)) {
    return std::nullopt;
  }
  const std::string zone = part[8].str();
  if (!zone.empty() && (zone[0] == '+' || zone[0] == '-')) {
    const int east =
        3600 * std::stoi(zone.substr(1, 2)) + 60 * std::stoi(zone.substr(zone.size() - 2));
    seconds -= zone[0] == '+' ? east : -east;
  }
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr std::size_t kPlaces = 9;
  std::string fraction = part[7].matched ? part[7].str().substr(1) : "";
  fraction.resize(kPlaces, '0');
  return static_cast<std::int64_t>(seconds) * kSecond + std::stoll(fraction);
}

}  // namespace sfw
