#include "structure_from_wifi/robot_name.h"

#include <functional>
#include <mutex>
#include <set>

namespace sfw {
namespace {

/// Every name that was ever made. It is never destroyed, since names may outlive any static object.
class Names {
 public:
  const std::string* find(std::string_view text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = texts_.find(text);
    return found != texts_.end() ? &*found : &*texts_.emplace(text).first;
  }

  static Names& all() {
    static Names& names = *new Names();
    return names;
  }

 private:
  std::mutex mutex_;
  std::set<std::string, std::less<>> texts_;  // its nodes stay where they are
};

}  // namespace

RobotName::RobotName(std::string_view text)
    : text_(text.empty() ? nullptr : Names::all().find(text)) {}

const std::string& RobotName::emptyText() {
  static const std::string& empty = *new std::string();
  return empty;
}

}  // namespace sfw
