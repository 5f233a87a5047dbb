#include "ros/mapping/diagnostics.h"

#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <fstream>
#include <optional>
#include <utility>

#include "files/text.h"
#include "ros/mapping/odometry_frame.h"

namespace sfw {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kPatience = 10.0;  // [s] without a reading

std::string joined(const std::vector<std::string>& words, const char* by) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : by) + word;
  }
  return text;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string seconds(double s) { return std::to_string(static_cast<long>(s)) + " s"; }

std::string radioTopics(const MappingStatus& status) {
  std::vector<std::string> topics;
  for (const InputStatistics::Input& input : status.inputs) {
    if (input.is_radio) {
      topics.push_back(input.topic);
    }
  }
  return joined(topics, " or ");
}

/// The first radio with messages that bring no reading, or nullptr. Another radio may bring some.
const InputStatistics::Input* uselessRadio(const MappingStatus& status) {
  const InputStatistics::Input* useless = nullptr;
  for (const InputStatistics::Input& input : status.inputs) {
    if (!input.is_radio || input.messages == 0) {
      continue;
    }
    if (input.last_observation_s && status.now_s - *input.last_observation_s < kPatience) {
      return nullptr;
    }
    useless = useless == nullptr ? &input : useless;
  }
  return useless;
}

double silentFor(const MappingStatus& status, const InputStatistics::Input& input) {
  return input.last_observation_s ? status.now_s - *input.last_observation_s : status.running_s;
}

/// Why a radio with messages brings no reading.
std::string whyUseless(const MappingStatus& status, const InputStatistics::Input& input) {
  const double since_message_s = status.now_s - input.last_message_s.value_or(0.0);
  const std::string reason = since_message_s >= kPatience
                                 ? "no message has come for " + seconds(since_message_s)
                             : input.problem.empty() ? "its scans are empty"
                                                     : input.problem;
  return input.topic + " brings no reading for " + seconds(silentFor(status, input)) + ": " +
         reason;
}

/// Resident memory of this process [MiB]; 0 if unknown.
double memoryMib() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t all = 0, resident = 0;
  file >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) /
         (1024.0 * 1024.0);
}

void addRejections(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  constexpr std::size_t kMostListed = 20;
  for (const auto& [result, count] : status.rejections.count) {
    to.add(std::string("rejected: ") + toString(result), count);
  }
  to.add("unknown access points", status.rejections.unknown_access_points.size());
  std::vector<std::string> unknown;
  for (const auto& [bssid, count] : status.rejections.unknown_access_points) {
    if (unknown.size() < kMostListed) {
      unknown.push_back(bssid.str());
    }
  }
  to.add("unknown access points: bssids", joined(unknown, " "));
}

void addAccessPoints(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  constexpr std::size_t kMostListed = 20;
  std::size_t heard = 0;
  for (std::size_t i = 0; i < status.map->access_points.size(); ++i) {
    const AccessPointSummary& summary = status.map->access_points[i];
    heard += summary.readings > 0 ? 1 : 0;
    if (i < kMostListed) {
      const AccessPointFit* fit = status.findings.fit(i);
      std::string text = std::to_string(summary.readings) + " readings";
      text += summary.radio ? ", one radio with " + summary.radio->str() : "";
      if (fit != nullptr) {
        text += formatted(", fit %.1f dB", fit->residual_db);
        text += fit->suspect ? ", contradicts its position" : "";
      }
      to.add("access point " + summary.access_point.bssid.str(), text);
    }
  }
  to.add("access points of the table", status.map->access_points.size());
  to.add("access points heard", heard);
}

void addMap(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  const Snapshot& map = *status.map;
  to.addf("free area", "%.1f m2", status.free_m2);
  to.addf("cells", "%ld x %ld", static_cast<long>(map.belief.geometry().width()),
          static_cast<long>(map.belief.geometry().height()));
  to.add("poses", map.path.size());
  to.add("stray poses", map.stray.count);
  to.addf("inference time", "%.2f s", status.inference_s);
  if (map.tomography && map.tomography->explained_variance > 0.0) {
    to.addf("variance explained by walls", "%.0f %%", 100.0 * map.tomography->explained_variance);
  }
  if (status.findings.drift) {
    to.addf("drift ratio", "%.2f", status.findings.drift->ratio);
  }
  addAccessPoints(status, to);
}

/// The readings that were kept, none of which belongs to an access point of the table.
bool hearsOnlyUnknown(const MappingStatus& status) {
  const auto& count = status.rejections.count;
  const auto unknown = count.find(InsertResult::kUnknownAccessPoint);
  return unknown != count.end() && unknown->second >= status.readings;
}

/// The most frequent reason for which the mapper refused readings, and their number.
std::optional<std::pair<InsertResult, std::size_t>> mostRefused(const Rejections& rejections) {
  std::optional<std::pair<InsertResult, std::size_t>> most;
  for (const auto& [result, count] : rejections.count) {
    if (result != InsertResult::kUnknownAccessPoint && (!most || count > most->second)) {
      most.emplace(result, count);
    }
  }
  return most;
}

std::string whyNoMap(const MappingStatus& status) {
  if (status.readings > 0) {
    return hearsOnlyUnknown(status)
               ? "no access point of the table was heard; compare its BSSIDs with those below"
               : "the readings do not suffice yet; drive on";
  }
  const std::string reason = whyNoReading(status);
  return reason.empty() ? "no reading is located yet" : reason;
}

}  // namespace

TransformStatus transformStatus(const RosSettings& config, const tf2::BufferCore& transforms,
                                const ros::Time& now) {
  TransformStatus status{config.map_frame, config.antenna_frame, {}, "", 0.0};
  status.odom_frame = odometryFrame(config, transforms);
  for (const std::string& frame : {config.map_frame, config.antenna_frame}) {
    if (!transforms._frameExists(frame)) {
      status.missing_frames.push_back(frame);
    }
  }
  try {
    const ros::Time latest =
        transforms.lookupTransform(config.map_frame, config.antenna_frame, ros::Time())
            .header.stamp;
    status.age_s = latest.isZero() ? 0.0 : now.toSec() - latest.toSec();  // zero: static
  } catch (const std::exception& error) {
    status.tf_error = error.what();
  }
  return status;
}

std::string whyNoReading(const MappingStatus& status) {
  if (status.is_paused) {
    return "mapping is paused";
  }
  if (status.is_clock_missing) {
    return "/use_sim_time is set, but no node publishes /clock";
  }
  // What is refused has come past tf.
  if (const auto refused = mostRefused(status.rejections);
      refused && refused->second > status.expired) {
    return std::to_string(refused->second) + " readings are refused: " + toString(refused->first);
  }
  if (status.waiting > 0 || status.expired > 0) {
    const TransformStatus& transform = status.transform;
    return !transform.missing_frames.empty()
               ? "tf has no frame " + joined(transform.missing_frames, ", ")
               : "tf has no transform from " + transform.antenna_frame + " to " +
                     transform.map_frame + " at the stamps of the readings";
  }
  if (const InputStatistics::Input* radio = uselessRadio(status)) {
    return whyUseless(status, *radio);
  }
  const bool silent = std::none_of(status.inputs.begin(), status.inputs.end(),
                                   [](const auto& i) { return i.is_radio && i.messages > 0; });
  return silent ? "no message has come on " + radioTopics(status) : "";
}

void describeInputs(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  if (!status.failure.empty()) {
    to.summary(DiagnosticStatus::ERROR, "Nothing is subscribed: mapping cannot start.");
    return;
  }
  to.summary(DiagnosticStatus::OK, "Readings arrive.");
  const InputStatistics::Input* useless = uselessRadio(status);
  const bool silent = std::all_of(status.inputs.begin(), status.inputs.end(), [&](const auto& i) {
    return !i.is_radio || !i.last_message_s || status.now_s - *i.last_message_s > kPatience;
  });
  if (status.is_paused) {
    to.summary(DiagnosticStatus::WARN, "Mapping is paused: readings are dropped.");
  } else if (silent) {
    to.summary(DiagnosticStatus::WARN, "No reading arrives on " + radioTopics(status) + ".");
  } else if (useless != nullptr && silentFor(status, *useless) >= kPatience) {
    to.summary(DiagnosticStatus::WARN, whyUseless(status, *useless) + ".");
  }
  to.add("paused", status.is_paused);
  for (const InputStatistics::Input& input : status.inputs) {
    to.add(input.topic + ": messages", input.messages);
    to.addf(input.topic + ": rate", "%.1f Hz", input.rate_hz);
    to.add(input.topic + ": usable", input.observations);
    for (const auto& [reason, count] : input.rejected) {
      to.add(input.topic + ": rejected: " + reason, count);
    }
  }
}

void describeTransforms(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  if (!status.failure.empty()) {
    to.summary(DiagnosticStatus::ERROR, "tf is not used: mapping cannot start.");
    return;
  }
  const TransformStatus& transform = status.transform;
  const std::string way = transform.antenna_frame + " to " + transform.map_frame;
  if (status.is_clock_missing) {
    to.summary(DiagnosticStatus::ERROR, "/use_sim_time is set, but no node publishes /clock.");
  } else if (!transform.missing_frames.empty()) {
    to.summary(DiagnosticStatus::ERROR,
               "tf has no frame " + joined(transform.missing_frames, ", ") + ".");
  } else if (!transform.tf_error.empty()) {
    to.summary(DiagnosticStatus::ERROR, "tf has no transform from " + way + ".");
  } else if (!status.frames.published_twice.empty()) {
    to.summary(DiagnosticStatus::WARN,
               "Two programs publish the transform from " + status.frames.published_twice + ".");
  } else if (transform.age_s > status.transform_timeout_s) {
    to.summary(DiagnosticStatus::WARN,
               "The last transform from " + way + " is " + seconds(transform.age_s) + " old.");
  } else {
    to.summary(DiagnosticStatus::OK, "tf has the transform from " + way + ".");
  }
  to.add("frame of the odometry", transform.odom_frame);
  to.add("transforms to and fro", status.frames.flips);
  to.add("transforms left out because they are not finite", status.infinite_transforms);
  to.add("missing frames", joined(transform.missing_frames, ", "));
  to.add("error of tf", transform.tf_error);
  to.add("readings waiting for a transform", status.waiting);
  to.add("readings dropped without a transform", status.expired);
  to.add("contacts dropped without a transform", status.expired_contacts);
  to.add("readings dropped because too many waited", status.overflowed);
  to.add("readings dropped because their pose jumped", status.jumped);
  to.add("readings with a tilted antenna", status.tilted);
}

void describeMap(const MappingStatus& status, DiagnosticStatusWrapper& to) {
  to.addf("memory", "%.0f MiB", memoryMib());
  if (!status.failure.empty()) {
    to.summary(DiagnosticStatus::ERROR, "Mapping cannot start: " + firstLine(status.failure));
    to.add("problems", status.failure);
    return;
  }
  if (!status.update_failure.empty()) {
    to.summary(DiagnosticStatus::ERROR, "The map update failed: " + status.update_failure);
  } else if (status.free_m2 <= 0.0) {
    to.summary(DiagnosticStatus::WARN, "There is no map yet: " + whyNoMap(status) + ".");
  } else if (!status.autosave_failure.empty()) {
    to.summary(DiagnosticStatus::WARN, "The session is not saved: " + status.autosave_failure);
  } else if (hearsOnlyUnknown(status)) {
    to.summary(DiagnosticStatus::WARN, "The map has no walls: " + whyNoMap(status) + ".");
  } else {
    to.summaryf(DiagnosticStatus::OK, "The map has %.1f m2 of free space from %zu readings.",
                status.free_m2, status.readings);
  }
  to.add("readings", status.readings);
  addRejections(status, to);
  if (status.map) {
    addMap(status, to);
  }
}

}  // namespace sfw
