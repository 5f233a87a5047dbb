#include "ros/conversion/robot_topics.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace sfw {
namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

bool isOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '/';
}

/// Whether a path is a folder or lies in it.
bool liesIn(const std::string& path, const std::string& folder) {
  return (path + '/').compare(0, folder.size() + 1, folder + '/') == 0;
}

std::string shortestBeginning(const std::string& frame, const std::vector<std::string>& all) {
  for (std::size_t end = frame.find('/'); end != std::string::npos;
       end = frame.find('/', end + 1)) {
    const std::string beginning = frame.substr(0, end);
    if (std::count_if(all.begin(), all.end(),
                      [&](const std::string& other) { return liesIn(other, beginning); }) == 1) {
      return beginning;
    }
  }
  return frame;
}

}  // namespace

std::vector<std::string> robotNames(const std::vector<std::string>& antenna_frames) {
  std::vector<std::string> names;
  for (const std::string& frame : antenna_frames) {
    std::string name = shortestBeginning(frame, antenna_frames);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !isOfName(c); }, '_');
    names.push_back(name.empty() || isLetter(name.front()) ? name : "robot_" + name);
  }
  return names;
}

std::string robotOfTopic(const std::string& topic, const std::vector<std::string>& antenna_frames) {
  if (antenna_frames.size() == 1) {
    return antenna_frames.front();
  }
  const std::vector<std::string> names = robotNames(antenna_frames);
  std::string robot;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_in = ('/' + topic).find('/' + names[i] + '/') != std::string::npos;
    if (is_in && names[i].size() > longest) {
      longest = names[i].size();
      robot = antenna_frames[i];
    }
  }
  return robot;
}

}  // namespace sfw
