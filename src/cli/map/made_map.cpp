#include "cli/map/made_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "cli/rejections.h"
#include "cli/warnings.h"
#include "output/moved.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"
#include "structure_from_wifi/map_notes.h"

namespace sfw {
namespace {

/// Reports the estimated positions of the first few access points; report.json has all of them.
/// @param source  the table, or else the recording
void reportEstimates(const std::string& source, const std::vector<AccessPointSummary>& summaries) {
  constexpr std::size_t kMostListed = 5;
  std::size_t estimated = 0;
  for (const AccessPointSummary& summary : summaries) {
    if (!summary.estimate || summary.radio || ++estimated > kMostListed) {
      continue;
    }
    const Position& position = summary.access_point.position;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << source << ": " << summary.access_point.bssid.str()
         << " is estimated at (" << position.x() << ", " << position.y() << "), standard deviation "
         << std::sqrt(summary.estimate->covariance.diagonal().maxCoeff()) << " m";
    std::cerr << "sfw: " << text.str() << '\n';
  }
  if (estimated > kMostListed) {
    std::cerr << "sfw: " << source << ": " << estimated - kMostListed
              << " more positions are estimated; report.json lists them\n";
  }
}

}  // namespace

void makeMap(const RecordingOptions& options, const std::string& directory) {
  LoadedRecording recording = loadRecording(options);
  const std::atomic<bool> never{false};
  std::shared_ptr<const Snapshot> made = recording.mapper.inferLast(never);
  const DataFindings findings = moved(DataChecker().checkAll(*made), recording.offset);
  const Snapshot snapshot = moved(*std::exchange(made, nullptr), recording.offset);
  const auto& found = snapshot.access_points;
  const bool any_used =
      std::any_of(found.begin(), found.end(), [](const auto& ap) { return ap.readings > 0; });
  reportRejections(recording.source, snapshot.rejections, snapshot.recording, any_used);
  reportEstimates(recording.table, found);
  for (const MapNote& note : mapNotes(snapshot, findings)) {
    if (any_used || isFault(note)) {  // the others are about a map that is not made
      warn(recording.source + ": " + note.text);
    }
  }
  if (!any_used) {
    throw InputError(recording.source + ": no reading " +
                     (recording.has_table ? "of an access point in " + recording.table + " " : "") +
                     "can be used; the warnings above give the reasons");
  }
  writeMapFiles(snapshot, recording.config, directory, findings);
}

}  // namespace sfw
