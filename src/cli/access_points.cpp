#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <tuple>
#include <vector>

#include "cli/commands.h"
#include "cli/recording_options.h"
#include "cli/rejections.h"
#include "cli/warnings.h"
#include "files/atomic_file.h"
#include "output/moved.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_notes.h"

namespace sfw {
namespace {

std::string inTenths(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

/// How well an estimated position is known.
std::string certaintyOf(const AccessPointEstimate& estimate) {
  std::string text = "+- " + inTenths(std::sqrt(estimate.covariance.diagonal().maxCoeff())) + " m";
  return estimate.ambiguous ? text + ", or at another likely place" : text;
}

/// What a person wants to know about an entry.
std::string commentOf(const AccessPointSummary& summary) {
  std::string text = std::to_string(summary.readings) + " readings";
  if (summary.radio) {
    return text + ", one radio with " + summary.radio->str();
  }
  if (!summary.estimate) {
    return text + (hasPosition(summary) ? ", position given" : ", too few to place it");
  }
  const Position& at = summary.estimate->position;
  const std::string certainty = certaintyOf(*summary.estimate);
  return isPlaced(summary) ? text + ", " + certainty
                           : text + ", perhaps at (" + inTenths(at.x()) + ", " + inTenths(at.y()) +
                                 ") " + certainty;
}

/// Entries of one radio follow each other. Radios with many readings come first.
std::vector<AccessPointSummary> ordered(std::vector<AccessPointSummary> summaries) {
  std::map<Bssid, std::size_t> most;
  const auto radioOf = [](const AccessPointSummary& one) {
    return one.radio.value_or(one.access_point.bssid);
  };
  for (const AccessPointSummary& one : summaries) {
    most[radioOf(one)] = std::max(most[radioOf(one)], one.readings);
  }
  std::stable_sort(summaries.begin(), summaries.end(), [&](const auto& a, const auto& b) {
    const auto rank = [&](const AccessPointSummary& one) {
      return std::make_tuple(std::numeric_limits<std::size_t>::max() - most[radioOf(one)],
                             radioOf(one), one.radio.has_value());
    };
    return rank(a) < rank(b);
  });
  return summaries;
}

/// The table as YAML, with a comment on each entry. Positions are those that a map would use.
std::string tableOf(const Snapshot& snapshot, const std::string& source) {
  std::ostringstream text;
  text << "# Access points heard in " << source << ". Correct the positions that you know.\n"
       << "access_points:\n";
  for (const AccessPointSummary& summary : ordered(snapshot.access_points)) {
    AccessPoint entry = summary.access_point;
    entry.position_known = isPlaced(summary);
    entry.position_sd_m.reset();  // the readings have been used: a prior would count them twice
    constexpr double kCentimetres = 100.0;
    entry.position = (entry.position * kCentimetres).array().round() / kCentimetres;
    const std::string yaml = accessPointsYaml({entry});
    // The key's line comes first, then the entry.
    const std::size_t begin = yaml.find('-');
    text << "  " << yaml.substr(begin, yaml.find_last_not_of('\n') + 1 - begin) << "  # "
         << commentOf(summary) << '\n';
  }
  return text.str();
}

void run(const RecordingOptions& options, const std::string& output) {
  const LoadedRecording recording = loadRecording(options);
  const Snapshot snapshot = moved(*recording.mapper.infer(), recording.offset);
  reportRejections(recording.source, snapshot.rejections, snapshot.recording,
                   !snapshot.access_points.empty());
  for (const MapNote& note : mapNotes(snapshot)) {
    if (note.kind == MapNote::Kind::kAccessPoint || note.kind == MapNote::Kind::kSignals ||
        note.kind == MapNote::Kind::kUnits) {
      warn(recording.source + ": " + note.text);
    }
  }
  if (snapshot.access_points.empty()) {
    throw InputError(recording.source +
                     ": no reading can be used; the warnings above give the reasons");
  }
  const std::string table = tableOf(snapshot, recording.source);
  if (output.empty()) {
    std::cout << table;
  } else {
    writeAtomically(output, table);
  }
}

}  // namespace

void runAccessPoints(Options& options) {
  RecordingOptions recording;
  std::string output;
  recording.declare(options);
  options.add("output", "FILE", output, "file for the table; default: standard output");
  if (!options.parse()) {
    return;
  }
  recording.check();
  run(recording, output);
}

}  // namespace sfw
