#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "localization/mapped_radio.h"
#include "localization/motion.h"
#include "localization/place_lattice.h"
#include "localization/radio_layers.h"
#include "localization/scan.h"
#include "localization/temper.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Signal strengths over the floor, learned from readings at known positions: what a scan says of
/// the place where it was taken (doc/method/localisation.md).
class RadioMap {
 public:
  struct Config {
    PlaceLattice::Config places;  ///< its deviation is measured, and its reach follows
    RadioLayers::Config layers;
    std::size_t fewest_scans = 4;  ///< radios heard in fewer scans are left out
    double block_m = 6.0;          ///< way of each block that is held out by turns
    std::size_t most_checked_scans = 400;
  };

  /// @param scans  with positions, by time, not empty
  /// @param table  access points; a known position is the source of the radio's path loss
  /// @throw InputError if the positions cover too large an area
  /// Once the flag `layers.stop` is true, the constructor ends soon, with a map of no use.
  /// The cost is about 7 ms for each radio, and 3 ms for each checked scan.
  RadioMap(const std::vector<Scan>& scans, const std::vector<AccessPoint>& table,
           const Config& config);
  RadioMap(const std::vector<Scan>& scans, const std::vector<AccessPoint>& table)
      : RadioMap(scans, table, Config()) {}

  const PlaceLattice& places() const { return places_; }
  const std::vector<MappedRadio>& radios() const { return radios_; }
  const Temper& temper() const { return temper_; }

  /// How the robot moved while it mapped.
  const Motion& motion() const { return motion_; }

  /// Tempered log likelihood of a scan at each place, up to a constant. The position of the scan
  /// is not used.
  /// @return nothing if it holds no radio of the map. O(places x radios of the scan).
  std::optional<std::vector<double>> logLikelihood(const Scan& scan) const;

 private:
  ScanRadios radiosOf(const Scan& scan) const;
  std::optional<std::size_t> numberOf(Bssid bssid) const;
  RadioLayers layersOf(const std::vector<Scan>& scans, const std::vector<bool>& used) const;
  std::vector<CheckedScan> checkedScans(const std::vector<Scan>& scans,
                                        const std::vector<int>& folds) const;

  Config config_;
  PlaceLattice places_;
  Motion motion_;
  std::vector<MappedRadio> radios_;  // by BSSID
  Eigen::MatrixXf correlation_;      // of the errors of each two radios
  Temper temper_;
  std::optional<RadioLayers> layers_;  // set by the constructor
};

}  // namespace sfw
