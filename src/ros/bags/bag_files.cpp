#include "ros/bags/bag_files.h"

#include <rosbag/view.h>

#include <fstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether a file begins as bags do, so that an error comes from what follows.
bool beginsAsBag(const std::string& file) {
  const std::string magic = "#ROSBAG V2";
  std::ifstream stream(file, std::ios::binary);
  std::string start(magic.size(), '\0');
  return stream.read(&start[0], static_cast<std::streamsize>(start.size())) && start == magic;
}

std::string whyUnreadable(const std::string& file, const std::string& error) {
  if (endsWith(file, ".active")) {
    return file + ": the recording was not ended, so the bag has no index: stop `rosbag record`, " +
           "or, if it was killed, run `rosbag reindex " + file + "`";
  }
  const std::string text = file + ": cannot be read as a bag: " + error;
  return beginsAsBag(file)
             ? text + ". If it was cut short, `rosbag reindex " + file + "` gives it a new index"
             : text;
}

}  // namespace

std::string plainTopic(const std::string& topic) {
  return !topic.empty() && topic.front() == '/' ? topic.substr(1) : topic;
}

BagFiles::BagFiles(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    try {
      bags_.push_back(std::make_unique<rosbag::Bag>(file, rosbag::bagmode::Read));
    } catch (const std::exception& error) {
      throw InputError(whyUnreadable(file, error.what()));
    }
  }
}

std::vector<std::string> BagFiles::topics() const {
  std::vector<std::string> topics;
  for (const auto& bag : bags_) {
    rosbag::View view(*bag);
    for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
      topics.push_back(plainTopic(connection->topic));
    }
  }
  return topics;
}

}  // namespace sfw
