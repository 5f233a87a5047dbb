#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulation/building/floor_plan.h"

namespace sfw {

/// The hash of a plan's cells and geometry, independent of its file.
std::uint64_t hashOf(const FloorPlan& plan);

/// Results of a benchmark, one file each, so that an interrupted run can resume.
///
/// Only a key of exactly the same text finds a result. Safe to use from several threads.
class BenchStore {
 public:
  /// Makes the directory. @throw std::system_error naming it
  explicit BenchStore(const std::string& directory);

  /// Removes incomplete files of killed runs. Call it only while no other run uses the directory.
  void removeUnfinished() const;

  /// The stored result of a key; nothing if there is none, or if its file is damaged.
  std::optional<std::string> find(const std::string& key) const;

  /// Stores the result of a key in place of an earlier one.
  /// @throw std::system_error naming the file and why
  void save(const std::string& key, const std::string& result) const;

 private:
  std::string fileOf(const std::string& key) const;

  std::string directory_;
};

}  // namespace sfw
