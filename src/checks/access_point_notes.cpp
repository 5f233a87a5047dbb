#include "checks/access_point_notes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "checks/drive_notes.h"
#include "checks/note_text.h"

namespace sfw {
namespace {

using Notes = std::vector<MapNote>;

/// Distinguishes notes on more and more access points. A live map would report each new one, so a
/// note is new when their number has doubled.
std::string aboutOf(const char* subject, std::size_t count) {
  std::size_t doubled = 1;
  while (2 * doubled <= count) {
    doubled *= 2;
  }
  return std::string(subject) + ' ' + std::to_string(doubled);
}

void addNoteOnMissingPositions(const Snapshot& snapshot, Notes& notes) {
  std::vector<Bssid> without;
  bool is_any_placed = false;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    is_any_placed = is_any_placed || (isPlaced(summary) && summary.readings > 0);
    if (!hasPosition(summary) && summary.readings > 0 && !summary.radio) {
      without.push_back(summary.access_point.bssid);
    }
  }
  // Without any position, another note says so. Without a table, some radios are always heard too
  // little.
  if (!without.empty() && is_any_placed && snapshot.has_table) {
    notes.push_back({MapNote::Kind::kTooLittle, "no position",
                     counted(without.size(), "access point is", "access points are") +
                         " left out, having no position and too few readings to estimate one: " +
                         named(without) + "; add x and y to the table"});
  }
}

void addNoteOnSinglePlace(const std::vector<Bssid>& radios, Notes& notes) {
  if (!radios.empty()) {
    notes.push_back({MapNote::Kind::kTooLittle, "single place",
                     counted(radios.size(), "access point is", "access points are") +
                         " heard at one place only: " + named(radios) +
                         "; their signals say nothing about walls; drive on, or add access points "
                         "that are heard on the whole path"});
  }
}

void addNoteOnAliases(const AliasFinding& aliases, Notes& notes) {
  if (aliases.groups.empty()) {
    return;
  }
  std::vector<std::string> groups;
  std::size_t bssids = 0;
  for (const std::vector<Bssid>& group : aliases.groups) {
    bssids += group.size();
    groups.push_back(group[0].str() + " = " + group[1].str() + (group.size() > 2 ? " = ..." : ""));
  }
  notes.push_back(
      {MapNote::Kind::kAccessPoint, aboutOf("aliases", bssids),
       std::to_string(bssids) + " BSSIDs are " + counted(groups.size(), "radio", "radios") +
           " under several BSSIDs, for their signals are the same everywhere: " + named(groups) +
           "; their readings are joined, so each radio counts once"});
}

void addNoteOnWrongPositions(const Snapshot& snapshot, const DataFindings& findings, Notes& notes) {
  std::vector<std::pair<double, std::string>> wrong;
  std::size_t examined = 0;
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    const AccessPointFit* fit = findings.fit(i);
    examined += fit != nullptr ? 1 : 0;
    if (fit != nullptr && fit->suspect) {
      wrong.emplace_back(-fit->distance_m, snapshot.access_points[i].access_point.bssid.str() +
                                               " (" + rounded(fit->distance_m, 1) +
                                               " m away, at (" +
                                               rounded(fit->estimate.position.x(), 1) + ", " +
                                               rounded(fit->estimate.position.y(), 1) + "))");
    }
  }
  if (wrong.empty()) {
    return;
  }
  std::sort(wrong.begin(), wrong.end());
  std::vector<std::string> names;
  for (const auto& [distance, name] : wrong) {
    names.push_back(name);
  }
  constexpr std::size_t kSeveral = 3;
  constexpr double kOutside = 30.0;  // [m], farther than anybody measures wrongly
  const bool is_other_frame =
      (wrong.size() == examined && examined >= kSeveral) || -wrong.front().first > kOutside;
  notes.push_back(
      {MapNote::Kind::kAccessPoint, aboutOf("wrong position", wrong.size()),
       "the readings of " + counted(wrong.size(), "access point", "access points") +
           " fit another position much better than the given one: " + named(names) +
           (is_other_frame ? "; check that table and readings are in metres and in the same frame"
                           : "; measure the position again")});
}

void addNoteOnAmbiguousPositions(const Snapshot& snapshot, Notes& notes) {
  std::vector<Bssid> ambiguous;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (summary.estimate && summary.estimate->ambiguous && !summary.radio) {
      ambiguous.push_back(summary.access_point.bssid);
    }
  }
  if (!ambiguous.empty()) {
    notes.push_back({MapNote::Kind::kAccessPoint, aboutOf("ambiguous", ambiguous.size()),
                     counted(ambiguous.size(), "access point has", "access points have") +
                         " several likely positions, such as on both sides of a straight path: " +
                         named(ambiguous) +
                         "; the map leaves out those that are uncertain by over 3 m; measure the "
                         "position, or drive around it"});
  }
}

}  // namespace

void addNoteOnSilence(const Snapshot& snapshot, Notes& notes) {
  std::vector<Bssid> silent;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    if (summary.heard == 0) {
      silent.push_back(summary.access_point.bssid);
    }
  }
  if (!silent.empty() && silent.size() < snapshot.access_points.size()) {
    notes.push_back({MapNote::Kind::kTooLittle, "never heard",
                     std::to_string(silent.size()) + " of " +
                         std::to_string(snapshot.access_points.size()) +
                         " access points of the table have no reading: " + named(silent) +
                         "; compare the BSSIDs, or drive nearer"});
  }
}

void addNotesOnRadios(const Snapshot& snapshot, Notes& notes) {
  addNoteOnMissingPositions(snapshot, notes);
  addNoteOnSinglePlace(snapshot.recording.single_place, notes);
  addNoteOnAliases(snapshot.recording.aliases, notes);
}

void addNotesOnPositions(const Snapshot& snapshot, const DataFindings& findings, Notes& notes) {
  addNoteOnWrongPositions(snapshot, findings, notes);
  if (!isStraight(snapshot.path)) {  // another note says what that leads to
    addNoteOnAmbiguousPositions(snapshot, notes);
  }
}

}  // namespace sfw
