#include "structure_from_wifi/map_notes.h"

#include <algorithm>

#include "checks/access_point_notes.h"
#include "checks/drive_notes.h"
#include "checks/note_text.h"
#include "checks/recording_checks.h"
#include "checks/recording_notes.h"

namespace sfw {
namespace {

using Notes = std::vector<MapNote>;

constexpr std::size_t kFewReadings = 50;

/// Readings of access points with a position.
std::size_t usedReadings(const Snapshot& snapshot) {
  std::size_t readings = 0;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    readings += isPlaced(summary) ? summary.readings : 0;
  }
  return readings;
}

void addNoteOnSignals(const Snapshot& snapshot, Notes& notes) {
  constexpr double kAlike = 0.5;  // [dB], half a step of most radios
  std::size_t all_readings = 0;
  const std::size_t readings = usedReadings(snapshot);
  double deviation_db = 0.0;
  bool is_any_estimated = false;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    all_readings += summary.readings;
    is_any_estimated = is_any_estimated || summary.estimate;
    if (isPlaced(summary)) {
      deviation_db = std::max(deviation_db, summary.rssi_deviation_db);
    }
  }
  if (!snapshot.recording.sentinels.empty() && readings < kFewReadings) {
    return;  // the others are left out, as another note says
  }
  if (all_readings == 0) {
    notes.push_back(
        {MapNote::Kind::kTooLittle, "",
         snapshot.has_table
             ? "no reading of an access point of the table can be used: the map follows from the "
               "path alone; compare the BSSIDs"
             : "no reading can be used: the map follows from the path alone"});
  } else if (readings == 0 && is_any_estimated) {
    if (!isStraight(snapshot.path)) {  // another note says what that leads to
      notes.push_back(
          {MapNote::Kind::kTooLittle, "",
           "the position of each access point is uncertain by over 3 m: the map follows "
           "from the path alone; drive on, or give positions"});
    }
  } else if (readings == 0) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     std::string("no access point with readings has a position: the map follows "
                                 "from the path alone; ") +
                         (snapshot.has_table ? "add positions to the table of access points"
                                             : "drive on, or give a table of access points with "
                                               "positions")});
  } else if (readings < kFewReadings) {
    notes.push_back({MapNote::Kind::kTooLittle, "",
                     "only " + counted(readings, "reading is", "readings are") +
                         " of access points with a position: too few to find walls; drive on"});
  } else if (deviation_db < kAlike) {
    notes.push_back({MapNote::Kind::kSignals, "",
                     "all signals of an access point are equal and contain no information about "
                     "walls; check that the wireless driver reports RSSI"});
  }
}

/// A map far from zero was made near zero.
void addNoteOnOffset(const Snapshot& snapshot, Notes& notes) {
  if (snapshot.offset.isZero()) {
    return;
  }
  notes.push_back({MapNote::Kind::kFrames, "offset",
                   "positions lie far from zero, as in UTM or a national grid: the map was made "
                   "with an offset of (" +
                       rounded(snapshot.offset.x(), 0) + ", " + rounded(snapshot.offset.y(), 0) +
                       ") m, and its files have the given coordinates again; it has no OctoMap, "
                       "which reaches less far"});
}

Notes notesOnData(const Snapshot& snapshot, const DataFindings& findings) {
  Notes notes;
  const RecordingFindings& recording = snapshot.recording;
  addNotesOnRecording(recording, notes);
  if (!recording.frames.missing.empty()) {
    return notes;  // there is hardly anything else
  }
  addNotesOnDrive(snapshot, notes);
  addNoteOnSilence(snapshot, notes);
  // From here on, each note could follow from one of the faults above.
  if (arePosesWrong(recording) || recording.signal_unit || !isDriven(snapshot.path)) {
    return notes;
  }
  addNoteOnSignals(snapshot, notes);
  const bool is_path_doubtful = isDoubtful(snapshot.motion);
  if (recording.gaps && !is_path_doubtful && usedReadings(snapshot) >= kFewReadings) {
    addNoteOnGaps(*recording.gaps, notes);
  }
  addNotesOnRadios(snapshot, notes);
  if (!is_path_doubtful && !recording.cached && !recording.bursts) {
    addNotesOnPositions(snapshot, findings, notes);
  }
  const bool is_faultless = std::none_of(notes.begin(), notes.end(), isFault);
  if (is_faultless && findings.drift && findings.drift->suspect) {
    notes.push_back({MapNote::Kind::kDrift, "",
                     "the path seems to have drifted: where it returns to a place, signals differ "
                     "as much as from room to room; improve the localisation"});
  }
  return notes;
}

}  // namespace

bool isFault(const MapNote& note) { return note.kind != MapNote::Kind::kTooLittle; }

std::vector<MapNote> mapNotes(const Snapshot& snapshot, const DataFindings& findings) {
  Notes notes = notesOnData(snapshot, findings);
  addNoteOnOffset(snapshot, notes);
  return notes;
}

}  // namespace sfw
