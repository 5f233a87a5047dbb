#pragma once

#include <cstddef>
#include <cstdint>

namespace sfw {

/// What random numbers are drawn for: nothing shares numbers with anything else.
enum class Purpose : std::uint64_t {
  kLevel,
  kFurniture,
  kWallVariation,
  kRobotPattern,
  kErrorX,  // of the reported path
  kErrorY,
  kDriftX,
  kDriftY,
  kAccessPointPattern,  // from here on: one for each access point
  kShadowing,
  kFading,
  kChannel,
  kMisses,
  kLeftOutBins,  // of an inference, not of a simulation
  kTrainingDrive,
  kTrainingCells
};

/// The stream of random numbers for a purpose.
constexpr std::uint64_t streamOf(Purpose purpose, std::size_t access_point = 0) {
  return (static_cast<std::uint64_t>(access_point) << 8) + static_cast<std::uint64_t>(purpose) + 1;
}

}  // namespace sfw
