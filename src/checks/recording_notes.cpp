#include "checks/recording_notes.h"

#include <cmath>

#include "checks/note_text.h"

namespace sfw {
namespace {

using Notes = std::vector<MapNote>;
using Scale = SignalUnitFinding::Scale;

std::string lengthAdvice(LengthUnit unit) {
  const std::string scale = "; scale them to metres, such as with sfw map --scale ";
  switch (unit) {
    case LengthUnit::kPixels:
      return "x and y look like pixels of a picture" + scale + "0.05 for pixels of 5 cm";
    case LengthUnit::kCentimetres:
      return "x and y look like centimetres" + scale +
             "0.01 (or the size of a pixel, if they are "
             "pixels)";
    case LengthUnit::kMillimetres:
      return "x and y look like millimetres" + scale + "0.001";
    case LengthUnit::kMetres:
      break;
  }
  return "";
}

std::string timeAdvice(TimeUnit unit) {
  switch (unit) {
    case TimeUnit::kMilliseconds:
      return "stamps look like milliseconds; divide them by 1000";
    case TimeUnit::kMicroseconds:
      return "stamps look like microseconds; divide them by 1000000";
    case TimeUnit::kMinutes:
      return "stamps look like minutes; multiply them by 60";
    case TimeUnit::kDays:
      return "stamps look like days, as a spreadsheet counts them; multiply them by 86400";
    case TimeUnit::kSeconds:
      break;
  }
  return "";
}

void addNoteOnUnits(const UnitFinding& units, Notes& notes) {
  const std::string length = lengthAdvice(units.length);
  const std::string time = timeAdvice(units.time);
  notes.push_back({MapNote::Kind::kUnits, "",
                   length + (length.empty() || time.empty() ? "" : "; ") + time +
                       ". Otherwise the robot would drive " + roughly(units.usual_speed_m_s) +
                       " m/s in an area of " + roughly(units.extent_m) + " m"});
}

const char* adviceOn(Scale scale) {
  switch (scale) {
    case Scale::kPercent:
      return "look like percent or another quality; convert them to dBm, such as by percent / 2 - "
             "100";
    case Scale::kWithoutSign:
      return "look like dBm without the minus sign; put it before them";
    case Scale::kUnsignedByte:
      return "look like unsigned bytes; subtract 256";
    case Scale::kTenths:
      return "look like tenths of dBm; divide them by 10";
    case Scale::kMilliDbm:
      return "look like mBm; divide them by 100";
    case Scale::kPositive:
      break;
  }
  return "look like percent (convert them, such as by percent / 2 - 100) or like dBm without the "
         "minus sign (put it before them)";
}

void addNoteOnSignalUnit(const SignalUnitFinding& unit, Notes& notes) {
  notes.push_back({MapNote::Kind::kSignals, "unit",
                   counted(unit.readings, "signal", "signals") + " from " + roughly(unit.lowest) +
                       " to " + roughly(unit.highest) + " of " +
                       counted(unit.radios.size(), "access point", "access points") + " (" +
                       named(unit.radios) + ") are no dBm and not used: they " +
                       adviceOn(unit.scale)});
}

void addNoteOnSentinels(const std::vector<SentinelFinding>& sentinels, Notes& notes) {
  std::string values;
  std::string about;
  for (const SentinelFinding& sentinel : sentinels) {
    const std::string value = roughly(sentinel.value_dbm);
    values += (values.empty() ? "" : " and ") + counted(sentinel.readings, "reading", "readings") +
              " of " + value + " dBm (" + named(sentinel.radios) + ")";
    about += value + " ";
  }
  notes.push_back({MapNote::Kind::kSignals, "not heard " + about,
                   values + " are not used: this value stands for 'not heard', for it is the "
                            "same at any place and far from the other signals; do not record "
                            "radios that are not heard"});
}

void addNoteOnCache(const CachedFinding& cached, Notes& notes) {
  notes.push_back({MapNote::Kind::kSignals, "cached",
                   "signals of " + counted(cached.radios.size(), "access point", "access points") +
                       " (" + named(cached.radios) + ") repeat " + rounded(cached.readings, 1) +
                       " times, over " + rounded(cached.way_m, 1) +
                       " m of driving, before they change: the driver repeats old scans, and the "
                       "map takes each value once; better record "
                       "each scan once, "
                       "at the time when it was heard"});
}

void addNoteOnOverlap(const OverlapFinding& overlap, Notes& notes) {
  const std::string what = "the path is in two places at once: it goes to and fro " +
                           counted(overlap.times, "time", "times") + ", by up to " +
                           rounded(overlap.farthest_m, 0) + " m, first at " +
                           secondsText(overlap.first_stamp_ns);
  if (overlap.step_back_s > 0.0) {
    notes.push_back({MapNote::Kind::kStamps, "step back",
                     what + "; the stamps step back by up to " + rounded(overlap.step_back_s, 1) +
                         " s in the recording; split it there, and let nothing set the clock "
                         "during a drive"});
  } else {
    notes.push_back({MapNote::Kind::kFrames, "two places",
                     what + "; look for two programs that publish the same transform or pose, and "
                            "stop one of them"});
  }
}

void addNoteOnBursts(const BurstFinding& bursts, Notes& notes) {
  notes.push_back({MapNote::Kind::kStamps, "bursts",
                   "readings come in bursts: " + rounded(bursts.readings, 0) +
                       " of an access point at once, each " + rounded(bursts.period_s, 1) +
                       " s and " + rounded(bursts.way_m, 1) +
                       " m; stamp each reading when it is heard, not when it is delivered"});
}

void addNoteOnFrames(const FrameFinding& frames, Notes& notes) {
  if (!frames.missing.empty()) {
    notes.push_back({MapNote::Kind::kFrames, "missing " + frames.missing,
                     "no transform has the frame '" + frames.missing + "', so " +
                         counted(frames.lost, "reading has", "readings have") +
                         " no position; name the frames of this robot"});
  }
  if (!frames.published_twice.empty()) {
    notes.push_back({MapNote::Kind::kFrames, "two publishers",
                     "the transform from " + frames.published_twice + " goes to and fro " +
                         counted(frames.flips, "time", "times") +
                         ": two programs publish it; stop one of them"});
  }
  if (frames.floors_m.size() > 1) {
    std::vector<std::string> heights;
    for (const double height : frames.floors_m) {
      heights.push_back(rounded(height, 1) + " m");
    }
    notes.push_back({MapNote::Kind::kFrames, "floors",
                     "the robot drives on " + std::to_string(heights.size()) +
                         " floors, at heights of " + named(heights) +
                         "; make one map for each floor"});
  }
}

}  // namespace

void addNotesOnRecording(const RecordingFindings& recording, Notes& notes) {
  addNoteOnFrames(recording.frames, notes);
  if (recording.units) {
    addNoteOnUnits(*recording.units, notes);
  }
  if (recording.signal_unit) {
    addNoteOnSignalUnit(*recording.signal_unit, notes);
  }
  if (!recording.sentinels.empty()) {
    addNoteOnSentinels(recording.sentinels, notes);
  }
  if (recording.cached) {
    addNoteOnCache(*recording.cached, notes);
  }
  if (recording.overlap && recording.frames.published_twice.empty()) {
    addNoteOnOverlap(*recording.overlap, notes);
  }
  if (recording.bursts) {
    addNoteOnBursts(*recording.bursts, notes);
  }
}

}  // namespace sfw
