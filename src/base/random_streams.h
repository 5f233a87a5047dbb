#pragma once

#include <cstddef>
#include <cstdint>

namespace sfw {

/// The purposes of random numbers. No two purposes share numbers.
enum class Purpose : std::uint64_t {
  kLevel,
  kFurniture,
  kWallVariation,
  kRobotPattern,
  kErrorX,  // of the reported path
  kErrorY,
  kDriftX,
  kDriftY,
  kAccessPointPattern,  // this and the next four: one stream for each access point
  kShadowing,
  kFading,
  kChannel,
  kMisses,
  kLeftOutBins,  // of an inference, not of a simulation
  kTrainingDrive,
  kTrainingCells,
  kSurvey,  // this and the next two: of drives for the training of the wall network
  kWallDrive,
  kDisturbance,
  kEvaluatedPlaces,  // of an evaluation
  kEvaluatedRoutes,
  kLocalization,
  kRandomWalk  // of an exploration
};

/// The stream of random numbers for a purpose.
constexpr std::uint64_t streamOf(Purpose purpose, std::size_t access_point = 0) {
  return (static_cast<std::uint64_t>(access_point) << 8) + static_cast<std::uint64_t>(purpose) + 1;
}

}  // namespace sfw
