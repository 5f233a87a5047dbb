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

/// A WiFi band.
enum class Band : std::uint8_t { k2400MHz, k5000MHz };

/// The centre of a usual channel of a band, 6 or 36 [MHz].
double frequencyMhz(Band band);

/// The differences of a band from 2.4 GHz, for which RadioModel::Config gives losses.
struct BandFigures {
  double loss_at_1m_db;         ///< in free space, on top of the loss at 2.4 GHz
  double interior_wall_factor;  ///< of the loss of interior walls
  double outer_wall_factor;     ///< of the loss of outer walls
};

/// The figures of a band.
///
/// At 5 GHz free space loses 20 log10(5180 / 2437) dB more. Walls follow ITU-R P.2040 at normal
/// incidence: interior walls as brick (3.9 and 4.0 dB), outer walls as concrete (14.8 and 26.5 dB).
BandFigures bandFigures(Band band);

/// An access point and the band on which it transmits.
struct Transmitter {
  AccessPoint access_point;
  Band band = Band::k2400MHz;
};

/// The transmitters of access points, all on one band.
std::vector<Transmitter> asTransmitters(const std::vector<AccessPoint>& access_points,
                                        Band band = Band::k2400MHz);

/// Models the signal strength in a building whose walls are known.
///
/// The mean at a position, in dBm, is
///
///   rssi_at_1m - 10 exponent log10(d) - S(sum of losses) + shadowing + gains of both antennas
///
/// with the distance d in space. The losses are those of the walls on the straight line, by
/// material and band, and of the furniture there. S(L) = max (1 - exp(-L / max)) limits their sum,
/// because signals also propagate around many walls. A wall's loss varies from place to place
/// (correlation 1/e in 2 m, loss never below 0), equally for every ray through it. Shadowing
/// changes with the robot's position, independently for each access point. An antenna's gain has a
/// first and a second harmonic of bearing. Each has the amplitude `pattern`, so this is the
/// standard deviation over all bearings. The pattern of the access point is fixed; the robot's
/// pattern turns with the robot. A sample adds fading and is rounded.
///
/// Every value is a function of its arguments and the seed, independent of earlier calls. It is the
/// same on all machines up to the last bit of their mathematical library. Immutable.
class RadioModel {
 public:
  /// Settings of the model.
  ///
  /// The defaults of path loss and walls were fitted to a recording in a furnished flat at 2.4 GHz.
  /// The noise is somewhat weaker than in homes; brackets give the ranges measured there.
  /// noise_level.h has other sets.
  struct Config {
    double rssi_at_1m_dbm = -31.0;            ///< for a transmit power of 20 dBm (-28 to -34) [dBm]
    double exponent = 1.2;                    ///< of path loss without the walls (1.0 to 2.4)
    double interior_wall_loss_db = 8.3;       ///< mean over places, 2.4 GHz (1.4 to 8.3) [dB]
    double interior_wall_variation_db = 0.0;  ///< standard deviation over places [dB]
    double outer_wall_loss_db = 12.0;         ///< mean; wood 4, stone 12, concrete 15 [dB]
    double outer_wall_variation_db = 0.0;     ///< standard deviation over places [dB]
    double max_obstacle_loss_db = 0.0;  ///< limit of the sum of losses (10 to 15) [dB]; 0: none
    double shadowing_db = 2.5;          ///< standard deviation over places (3 to 8) [dB]
    double shadowing_distance_m =
        1.5;                       ///< distance at which its correlation is 1/e (0.9 to 2.1) [m]
    double sample_noise_db = 2.0;  ///< standard deviation at one position (2.8 to 3.3) [dB]
    double access_point_pattern_db = 0.0;  ///< standard deviation of its antenna's gain [dB]
    double robot_pattern_db = 0.0;         ///< standard deviation of its antenna's gain [dB]
    double max_furniture_loss_db = 0.0;    ///< of a piece in each 9 m2 (5) [dB]
    double rssi_step_db = 1.0;             ///< signals are its multiples [dB]; 0: not rounded
    double antenna_height_m = 0.3;         ///< of the robot, for access points of known height [m]
    double sensitivity_dbm = -90.0;        ///< weaker signals are not received [dBm]
    double missed_share = 0.0;             ///< share of the other samples that is lost too
    std::int64_t seed = 1;                 ///< of all random numbers
  };

  /// @throw InputError naming every setting of `config` that is out of range and every access point
  /// outside the plan.
  RadioModel(const FloorPlan& plan, const std::vector<Transmitter>& transmitters,
             const Config& config);

  const std::vector<Transmitter>& transmitters() const { return transmitters_; }

  /// The mean of many samples at a pose [dBm], missed samples included.
  /// @param access_point   index in transmitters()
  /// @param robot_in_map   inside the plan
  /// O(cells between them + pieces of furniture).
  double meanRssi(std::size_t access_point, const RobotPose& robot_in_map) const;

  /// One sample [dBm], at most 0; nothing if it is not received.
  /// @param sample  number of the sample of this access point
  std::optional<double> rssi(std::size_t access_point, const RobotPose& robot_in_map,
                             std::uint64_t sample) const;

  /// The loss of walls and furniture between an access point and a position, limited [dB].
  double obstacleLoss(std::size_t access_point, const Position& antenna_in_map) const;

  /// The number of walls between an access point and a position, as countWalls finds it.
  int wallCount(std::size_t access_point, const Position& antenna_in_map) const;

 private:
  /// The gain over bearing: a first and a second harmonic of one amplitude.
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
