#include "training/survey.h"

#include <cmath>

#include "base/constants.h"
#include "structure_from_wifi/input_error.h"
#include "training/survey_places.h"
#include "training/training_world.h"

namespace sfw {
namespace {

bool happens(double probability, Random& random) { return random.uniform() <= probability; }

/// Some access points, often with a second band, which has a BSSID of its own.
std::vector<Transmitter> chooseTransmitters(const FloorPlan& plan, std::int64_t seed,
                                            Random& random) {
  constexpr double kMost = 40.0;
  constexpr std::size_t kSecondBand = 100;  // BSSIDs from here on
  const auto count = chooseCount(kMost, random);
  std::vector<Transmitter> transmitters = asTransmitters(placeAccessPoints(plan, count, seed));
  if (happens(0.4, random)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      Transmitter second{transmitters[i].access_point, Band::k5000MHz};
      second.access_point.bssid = numberedBssid(kSecondBand + i);
      transmitters.push_back(second);
    }
  }
  return transmitters;
}

/// Measures at the places of a walk.
class Surveyor {
 public:
  Surveyor(const RadioModel& radio, Random& random)
      : radio_(radio),
        random_(random),
        position_error_m_(happens(0.5, random) ? 0.0 : random.uniform(0.0, 0.15)),
        readings_a_place_(1 + static_cast<int>(random.uniform(0.0, 3.99))),
        measures_again_(happens(0.3, random)) {}

  std::vector<Reading> measure(const SurveyPlaces& places, const std::vector<std::size_t>& walk) {
    std::vector<bool> done;
    for (const std::size_t place : walk) {
      done.resize(std::max(done.size(), place + 1));
      const int times = !done[place] ? readings_a_place_ : measures_again_ ? 1 : 0;
      measureAt(places.position(place), times);
      done[place] = true;
      stamp_ns_ += kSecond;  // on the way to the next place
    }
    return readings_;
  }

 private:
  static constexpr std::int64_t kSecond = 1000000000;  // [ns]

  void measureAt(const Position& place, int times) {
    const Position reported =
        place + position_error_m_ * Position(random_.normal(), random_.normal());
    for (int time = 0; time < times; ++time) {
      const RobotPose pose{place, 0.5 * kPi * time};  // the person turns
      for (std::size_t i = 0; i < radio_.transmitters().size(); ++i) {
        if (const std::optional<double> rssi_dbm = radio_.rssi(i, pose, sample_)) {
          readings_.push_back(
              {stamp_ns_, reported, radio_.transmitters()[i].access_point.bssid, *rssi_dbm});
        }
      }
      ++sample_;
      stamp_ns_ += kSecond;
    }
  }

  const RadioModel& radio_;
  Random& random_;
  double position_error_m_;
  int readings_a_place_;
  bool measures_again_;
  std::vector<Reading> readings_;
  std::int64_t stamp_ns_ = kSecond;
  std::uint64_t sample_ = 0;
};

}  // namespace

std::optional<TrainingDrive> makeSurvey(const FloorPlan& plan, const NoiseLevel& noise,
                                        std::int64_t seed, Random& random) {
  constexpr std::size_t kFewestPlaces = 30;
  FloorPlan walls = plan;
  if (happens(0.4, random)) {
    cutOut(walls, random);
  }
  FloorPlan furnished = walls;
  if (happens(0.3, random)) {
    furnish(furnished, random);
  }
  const SurveyPlaces places(furnished, random);
  const std::vector<std::size_t> walk = places.walk(random);
  if (walk.size() < kFewestPlaces) {
    return std::nullopt;
  }
  TrainingDrive drive{{}, {}, DrivingStyle::kPatrol, toStates(furnished), toStates(furnished)};
  RadioModel::Config radio = radioConfig(noise, seed);
  varyRadio(radio, random);
  try {
    const RadioModel model(walls, chooseTransmitters(furnished, seed, random), radio);
    for (const Transmitter& one : model.transmitters()) {
      drive.access_points.push_back(one.access_point);
    }
    drive.readings = Surveyor(model, random).measure(places, walk);
  } catch (const InputError&) {
    return std::nullopt;
  }
  drive.truth = visibleStates(pathOf(drive.readings), drive.building);
  return drive;
}

}  // namespace sfw
