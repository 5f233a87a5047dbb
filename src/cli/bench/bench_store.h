#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "simulation/building/floor_plan.h"

namespace sfw {

/// The whole file; empty if it cannot be read.
std::string bytesOf(const std::string& file);

/// FNV-1a, 64 bit; `seed` continues an earlier one.
std::uint64_t hashOf(const std::string& bytes, std::uint64_t seed = 0xcbf29ce484222325ULL);

/// Of a plan's cells and geometry, whatever file it came from.
std::uint64_t hashOf(const FloorPlan& plan);

/// Of the running program and the core library: another build may come to other figures.
std::uint64_t hashOfProgram();

/// Results that a benchmark has come to, one file each, so that an interrupted run can go on.
///
/// A result is found again only by a key of the very same text. Safe to use from several threads.
class BenchStore {
 public:
  /// Makes the directory, and removes what a killed run left half-written in it.
  /// @throw std::system_error naming it
  explicit BenchStore(const std::string& directory);

  std::optional<std::string> find(const std::string& key) const;

  /// @throw std::system_error
  void save(const std::string& key, const std::string& result) const;

 private:
  std::string fileOf(const std::string& key) const;

  std::string directory_;
};

}  // namespace sfw
