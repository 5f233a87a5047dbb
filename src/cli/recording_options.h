#pragma once

#include <string>

#include "cli/bag_options.h"
#include "cli/options.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// The options of a subcommand that reads a recording.
struct RecordingOptions {
  std::string readings;
  BagOptions bags;
  std::string access_points;
  std::string contacts;
  std::string path;
  double scale = 1.0;
  std::string config;

  /// Declares the options.
  void declare(Options& options);

  /// @throw InputError if options contradict each other.
  void check() const;
};

/// A recording in a mapper.
struct LoadedRecording {
  Config config;
  Mapper mapper;
  std::string source;  ///< its file, or its bags, for messages
  std::string table;   ///< the file of access points, or else the source
  bool has_table;      ///< whether a file of access points is given

  /// Subtracted from all positions [m], since they lie far from zero.
  Position offset;
};

/// Reads a recording and inserts it into a mapper. Prints warnings on what cannot be inserted; the
/// caller tells what the mapper refused (reportRejections).
/// @throw InputError that names the file or the setting that cannot be used
LoadedRecording loadRecording(const RecordingOptions& options);

}  // namespace sfw
