#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/building/floor_plan.h"
#include "simulation/building/furniture.h"
#include "simulation/building/wall_crossings.h"
#include "simulation/radio/random_field.h"
#include "simulation/robot/route.h"
#include "structure_from_wifi/types.h"

namespace sfw {

enum class Band : std::uint8_t { k2400MHz, k5000MHz };

/// Centre of a usual channel, 6 or 36 [MHz].
double frequencyMhz(Band band);

/// What one band differs in from 2.4 GHz, for which losses are given.
struct BandFigures {
  double loss_at_1m_db;         ///< more lost in free space
  double interior_wall_factor;  ///< on the loss of interior walls
  double outer_wall_factor;
};

/// 5 GHz: 20 log10(5180 / 2437) in free space; walls by ITU-R P.2040 at normal incidence, interior
/// as brick (3.9 to 4.0 dB; drywall gets more transparent, concrete less), outer as concrete
/// (26.5 to 14.8 dB).
BandFigures bandFigures(Band band);

/// An access point that sends.
struct Transmitter {
  AccessPoint access_point;
  Band band = Band::k2400MHz;
};

/// Each access point on one band.
std::vector<Transmitter> asTransmitters(const std::vector<AccessPoint>& access_points,
                                        Band band = Band::k2400MHz);

/// Signal strength in a building whose walls are known.
///
/// The mean at a place, in dBm, is
///
///   rssi_at_1m - 10 exponent log10(d) - S(sum of losses) + shadowing + both antennas' gains
///
/// with d the distance in space. Losses are those of the walls on the straight line, by material
/// and band, and of the furniture there; S(L) = saturation (1 - exp(-L / saturation)), as signals
/// find ways round many walls. A wall's loss varies from place to place (1/e in 2 m, and never
/// below 0) whichever ray goes through it. Shadowing changes with the robot's place, independently
/// for each access point. An antenna's gain has a first and a second harmonic of bearing, each with
/// an amplitude of `pattern`, thus that standard deviation over all bearings; the access point's
/// pattern stands still, the robot's turns with it. A sample adds fading and is rounded.
///
/// Every value is a function of its arguments and the seed, whatever was asked before, and the same
/// on all machines up to the last bit of their mathematical library. Immutable.
class RadioModel {
 public:
  /// Path loss and walls as fitted to a recording in a furnished flat at 2.4 GHz; noise somewhat
  /// kinder than measured in homes, whose ranges stand in brackets. noise_level.h has other sets.
  struct Config {
    double rssi_at_1m_dbm = -31.0;  ///< of an access point that sends 20 dBm (-28 to -34) [dBm]
    double exponent = 1.2;          ///< of path loss without the walls (1.0 to 2.4)
    double interior_wall_loss_db = 8.3;  ///< of each, 2.4 GHz, mean over places (1.4 to 8.3) [dB]
    double interior_wall_variation_db = 0.0;  ///< standard deviation over places [dB]
    double outer_wall_loss_db = 12.0;         ///< likewise; wood 4, stone 12, concrete 15 [dB]
    double outer_wall_variation_db = 0.0;     ///< standard deviation over places [dB]
    double max_obstacle_loss_db =
        0.0;                    ///< losses together stay below (10 to 15) [dB]; 0: they add up
    double shadowing_db = 2.5;  ///< standard deviation over places (3 to 8) [dB]
    double shadowing_distance_m = 1.5;     ///< its correlation falls to 1/e here (0.9 to 2.1) [m]
    double sample_noise_db = 2.0;          ///< standard deviation at one place (2.8 to 3.3) [dB]
    double access_point_pattern_db = 0.0;  ///< of antenna gain over bearing [dB]
    double robot_pattern_db = 0.0;         ///< of antenna gain over bearing [dB]
    double max_furniture_loss_db = 0.0;    ///< a piece in each 9 m2 takes up to this (5) [dB]
    double rssi_step_db = 1.0;             ///< signals are multiples of it [dB]; 0: not rounded
    double antenna_height_m = 0.3;         ///< of the robot, for access points of known height [m]
    double sensitivity_dbm = -90.0;        ///< anything weaker is not heard [dBm]
    double missed_share = 0.0;             ///< share of the other samples that is not heard either
    std::int64_t seed = 1;                 ///< of all that is random
  };

  /// @throw InputError naming every setting of `config` that is out of range and every access point
  /// outside the plan.
  RadioModel(const FloorPlan& plan, const std::vector<Transmitter>& transmitters,
             const Config& config);

  const std::vector<Transmitter>& transmitters() const { return transmitters_; }

  /// What the mean of many samples tends to, missed ones included [dBm].
  /// @param access_point   index in transmitters()
  /// @param robot_in_map   inside the plan
  /// O(cells between them + pieces of furniture).
  double meanRssi(std::size_t access_point, const RobotPose& robot_in_map) const;

  /// One sample, at most 0 dBm; nothing if it is not heard.
  /// @param sample  tells samples of one access point apart
  std::optional<double> rssi(std::size_t access_point, const RobotPose& robot_in_map,
                             std::uint64_t sample) const;

  /// What walls and furniture between an access point and a place take away, saturated [dB].
  double obstacleLoss(std::size_t access_point, const Position& antenna_in_map) const;

  /// Walls between an access point and a place, as countWalls has it.
  int wallCount(std::size_t access_point, const Position& antenna_in_map) const;

 private:
  /// Gain over bearing: a first and a second harmonic of one amplitude.
  struct AntennaPattern {
    AntennaPattern(double amplitude_db, std::int64_t seed, std::uint64_t stream);
    double gain(double bearing_rad) const;

    double amplitude_db;
    double first_phase_rad;
    double second_phase_rad;
  };

  double wallLoss(const WallCrossing& wall, Band band) const;

  FloorPlan plan_;
  std::vector<Transmitter> transmitters_;
  Config config_;
  std::vector<Furniture> furniture_;
  RandomField wall_variation_;
  AntennaPattern robot_pattern_;
  std::vector<RandomField> shadowing_;                 // of each access point
  std::vector<AntennaPattern> access_point_patterns_;  // of each access point
};

/// Every problem of a radio's settings, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const RadioModel::Config& config);

}  // namespace sfw
