#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/far_positions.h"
#include "cli/warnings.h"
#include "evaluation/localization_evaluation.h"
#include "files/atomic_file.h"
#include "files/scan_table.h"
#include "files/text.h"
#include "localization/odometry_steps.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

struct LocaliseOptions {
  std::string map_readings;
  std::string readings;
  std::string path;
  std::string odometry;
  std::string access_points;
  double scan_window_s = 0.5;
  std::int64_t seed = 0;
  bool json = false;
  std::string output;
};

/// The readings to localise, and whether their true positions are known.
struct UnknownReadings {
  std::vector<Reading> readings;
  bool have_truth = false;
};

/// Reads a file without x and y.
std::vector<Reading> unlocatedReadings(const std::string& file) {
  ScanTable table(file, false);
  std::vector<Reading> readings;
  std::size_t skipped = 0;
  std::string first;
  while (table.next()) {
    Reading reading;
    if (const auto fault = table.read(reading)) {
      first = skipped++ == 0 ? table.line() + ": " + fault->reason + ", " + fault->detail : first;
      continue;
    }
    readings.push_back(reading);
  }
  if (readings.empty()) {
    throw InputError(file + ": no row can be used: " + (first.empty() ? "it has no rows" : first));
  }
  if (skipped > 0) {
    warn(file + ": " + std::to_string(skipped) + " rows skipped (first: " + first + ")");
  }
  return readings;
}

UnknownReadings unknownReadings(const LocaliseOptions& options) {
  if (options.path.empty() && !ScanTable(options.readings, false).hasPositions()) {
    return {unlocatedReadings(options.readings), false};
  }
  return {readWithWarnings(options.readings, options.path).readings, true};
}

std::vector<std::optional<Position>> stepsOf(const LocaliseOptions& options,
                                             const std::vector<Scan>& scans) {
  if (options.odometry.empty()) {
    return std::vector<std::optional<Position>>(scans.size());
  }
  std::vector<std::optional<Position>> steps = odometrySteps(scans, readPath(options.odometry));
  const auto known =
      std::count_if(steps.begin(), steps.end(), [](const auto& step) { return step.has_value(); });
  if (known == 0 && scans.size() > 1) {
    throw InputError(options.odometry + ": no two scans of " + options.readings +
                     " in succession lie between its poses; bring both to one clock");
  }
  return steps;
}

std::string posesCsv(const std::vector<Scan>& scans, const std::vector<LocalizedScan>& localized,
                     const Position& offset) {
  std::string text = "stamp,x,y,var_x,cov_xy,var_y,sure\n";
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!localized[i].filtered) {
      continue;
    }
    const PlaceEstimate& estimate = *localized[i].filtered;
    const Position position = estimate.position + offset;
    text += formatted("%.3f,%.3f,%.3f,%.4f,%.4f,%.4f,%.3f\n",
                      1e-9 * static_cast<double>(scans[i].stamp_ns), position.x(), position.y(),
                      estimate.covariance(0, 0), estimate.covariance(0, 1),
                      estimate.covariance(1, 1), estimate.sure);
  }
  return text;
}

nlohmann::json toJson(const LocalizationErrors& errors) {
  nlohmann::json json{{"scans", errors.scans},
                      {"mean_m", errors.mean_m},
                      {"median_m", errors.median_m},
                      {"largest_of_90_percent_m", errors.largest_of_90_percent_m}};
  if (errors.in_ellipse) {
    json["in_ellipse"] = *errors.in_ellipse;
  }
  return json;
}

void printRow(const std::string& name, const LocalizationErrors& errors) {
  std::cout << std::left << std::setw(24) << name << std::right << std::fixed
            << std::setprecision(2) << std::setw(8) << errors.mean_m << std::setw(8)
            << errors.median_m << std::setw(8) << errors.largest_of_90_percent_m << std::setw(12);
  if (errors.in_ellipse) {
    std::cout << *errors.in_ellipse << '\n';
  } else {
    std::cout << '-' << '\n';
  }
}

void print(const LocalizationEvaluation& evaluation, const NearestFingerprints& fingerprints,
           bool as_json) {
  if (as_json) {
    nlohmann::json json{{"particle_filter", toJson(evaluation.filtered)},
                        {"one_scan", toJson(evaluation.alone)},
                        {"nearest_fingerprints", toJson(evaluation.nearest)}};
    json["nearest_fingerprints"]["k"] = fingerprints.neighbours();
    std::cout << json.dump(2) << '\n';
    return;
  }
  std::cout << "Errors of " << evaluation.filtered.scans << " scans [m]\n"
            << std::left << std::setw(24) << "" << std::right << std::setw(8) << "mean"
            << std::setw(8) << "median" << std::setw(8) << "90 %" << std::setw(12) << "in ellipse"
            << '\n';
  printRow("particle filter", evaluation.filtered);
  printRow("one scan alone", evaluation.alone);
  printRow(std::to_string(fingerprints.neighbours()) + " nearest fingerprints", evaluation.nearest);
}

RadioMap learn(const LocaliseOptions& options, const std::vector<Scan>& mapped,
               const Position& offset) {
  std::vector<AccessPoint> table;
  if (!options.access_points.empty()) {
    table = accessPointsWithWarnings(options.access_points);
    subtract(offset, table);
    requireSameFrame(offset, table, options.access_points);
  }
  try {
    return {mapped, table};
  } catch (const InputError& error) {
    throw InputError(options.map_readings + ": " + error.what());
  }
}

void run(const LocaliseOptions& options) {
  const auto window_ns = static_cast<std::int64_t>(1e9 * options.scan_window_s);
  std::vector<Reading> map_readings = readWithWarnings(options.map_readings, options.path).readings;
  UnknownReadings unknown = unknownReadings(options);
  const Position offset = offsetOf(map_readings);
  subtract(offset, map_readings);
  if (unknown.have_truth) {
    subtract(offset, unknown.readings);
  }
  const std::vector<Scan> mapped = scansOf(std::move(map_readings), window_ns);
  const std::vector<Scan> scans = scansOf(std::move(unknown.readings), window_ns);
  const RadioMap map = learn(options, mapped, offset);
  ParticleFilter::Config config;
  config.seed = options.seed;
  const std::vector<LocalizedScan> localized =
      localizeScans(map, scans, stepsOf(options, scans), config);
  const auto lost = std::count_if(localized.begin(), localized.end(),
                                  [](const LocalizedScan& one) { return !one.alone; });
  if (lost == static_cast<std::ptrdiff_t>(localized.size())) {
    throw InputError(options.readings + ": no scan holds a BSSID of the radio map of " +
                     options.map_readings + " (" + std::to_string(map.radios().size()) +
                     " BSSIDs, each heard in " + std::to_string(RadioMap::Config().fewest_scans) +
                     " scans or more); both must be of one building");
  }
  if (lost > 0) {
    warn(options.readings + ": " + std::to_string(lost) + " of " +
         std::to_string(localized.size()) + " scans hold no BSSID of the radio map");
  }
  if (unknown.have_truth) {
    const NearestFingerprints fingerprints(mapped, RadioMap::Config().block_m);
    print(evaluateLocalization(scans, localized, fingerprints), fingerprints, options.json);
  }
  if (!options.output.empty()) {
    writeAtomically(options.output, posesCsv(scans, localized, offset));
    std::cerr << "sfw: wrote the poses to " << options.output << '\n';
  }
}

}  // namespace

void runLocalise(Options& options) {
  LocaliseOptions localise;
  options.addRequired("map-readings", "FILE", localise.map_readings,
                      "CSV with the columns stamp, x, y, bssid, rssi_dbm: readings to learn from");
  options.addRequired("readings", "FILE", localise.readings,
                      "CSV with the columns stamp, bssid, rssi_dbm: readings to localise. With x "
                      "and y, errors are printed");
  options.add("path", "FILE", localise.path,
              "CSV with the columns stamp, x, y: places readings of either file that have no x "
              "and y");
  options.add("odometry", "FILE", localise.odometry,
              "CSV with the columns stamp, x, y in the frame of the odometry, while the robot is "
              "localised");
  options.add("access-points", "FILE", localise.access_points,
              "YAML: access_points: [{bssid, x, y, z?, name?, tx_dbm?}]; known positions help");
  options.add("scan-window", "SECONDS", localise.scan_window_s,
              "readings within this time are one scan");
  options.add("seed", "N", localise.seed, "seed of the particle filter");
  options.addFlag("json", localise.json, "print the errors as JSON");
  options.add("output", "FILE", localise.output,
              "CSV of poses: stamp, x, y, var_x, cov_xy, var_y, sure");
  if (!options.parse()) {
    return;
  }
  constexpr double kLongestWindowS = 60.0;
  if (!(localise.scan_window_s >= 0.0 && localise.scan_window_s <= kLongestWindowS)) {
    throw InputError("--scan-window must be in 0..60 seconds");
  }
  run(localise);
}

}  // namespace sfw
