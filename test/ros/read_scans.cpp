// Prints the readings of all messages in a bag, for scan_messages_test.py.
//
// Usage: read_scans BAG [SETTINGS]
// A reading is a line: topic, BSSID, dBm and nanoseconds. A problem is a line: topic, "problem",
// the number of readings rejected for it, and the words. Tabulators stand between them.

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <map>

#include "ros/conversion/input_messages.h"
#include "ros/conversion/ros_settings.h"

namespace {

void print(const std::string& topic, const sfw::Conversion& conversion) {
  for (const sfw::Observation& observation : conversion.observations) {
    const auto& reading = std::get<sfw::UnlocatedReading>(observation.content);
    std::printf("%s\t%s\t%.3f\t%llu\n", topic.c_str(), reading.bssid.str().c_str(),
                reading.rssi_dbm, static_cast<unsigned long long>(observation.stamp.toNSec()));
  }
  std::map<std::string, std::size_t> problems = conversion.rejected;
  problems.emplace(conversion.problem, 0);
  problems.erase("");
  for (const auto& [problem, count] : problems) {
    std::printf("%s\tproblem\t%zu\t%s\n", topic.c_str(), count, problem.c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const sfw::MappingSettings settings =
        argc > 2 ? sfw::readMappingSettings(argv[2]) : sfw::MappingSettings();
    const rosbag::Bag bag(argv[1], rosbag::bagmode::Read);
    rosbag::View view(bag);
    for (const rosbag::MessageInstance& message : view) {
      const sfw::InputContext context{message.getTime(), "antenna", 0.2,
                                      sfw::toScanFormat(settings.scan)};
      print(message.getTopic(), sfw::convertReadings(sfw::toAnyMessage(message), context));
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
