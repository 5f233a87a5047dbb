#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <vector>

#include "localization/mapped_radio.h"
#include "localization/place_lattice.h"
#include "localization/scan.h"

namespace sfw {

/// The radios of one scan, by their numbers in the map.
struct ScanRadios {
  std::vector<HeardRadio> heard;
  std::vector<double> signal_weights;  ///< of each of `heard`
  std::vector<std::size_t> repeated;   ///< neither heard anew nor silent
};

/// What a scan says of each place, in parts that are tempered separately.
struct ScanEvidence {
  Eigen::ArrayXf signal;  ///< log likelihood of the strengths
  Eigen::ArrayXf heard;   ///< log probability of hearing these radios and no others
};

/// For each radio and each place: expected strength, its deviation, and the chance of being heard.
///
/// The chance is the share of mapped scans nearby that heard the radio, by an exponential kernel.
/// Errors of strengths follow Student's t distribution.
class RadioLayers {
 public:
  struct Config {
    double heard_reach_m = 2.0;               ///< reach of the kernel
    double heard_prior = 0.3;                 ///< weight of a radio's share of all scans, in scans
    double most_in_square = 4.0;              ///< scans that count in one square
    double freedom = 10.0;                    ///< of Student's t distribution, above 2
    const std::atomic<bool>* stop = nullptr;  ///< once it is true, the other radios stay unknown
  };

  /// @param scans   all mapped scans
  /// @param used    whether each scan is used: others are held out
  /// @param weights of each radio, for its being heard or not
  RadioLayers(const PlaceLattice& places, const std::vector<Scan>& scans,
              const std::vector<bool>& used, const std::vector<MappedRadio>& radios,
              std::vector<double> weights, const Config& config);

  /// Evidence of one scan at each place. O(places x radios of the scan).
  ScanEvidence evidence(const ScanRadios& scan) const;

 private:
  struct Layer {
    Eigen::ArrayXf mean_dbm;
    Eigen::ArrayXf precision;      // one over the deviation [1/dB]
    Eigen::ArrayXf log_precision;  // its logarithm
    Eigen::ArrayXf log_heard;
    Eigen::ArrayXf log_silent;
  };

  /// Whether a radio has any used reading.
  bool known(std::size_t radio) const { return layers_[radio].mean_dbm.size() > 0; }
  void addChances(const PlaceLattice& places, const std::vector<Scan>& scans,
                  const std::vector<bool>& used, const std::vector<MappedRadio>& radios);

  Config config_;
  std::vector<double> weights_;
  std::vector<Layer> layers_;  // of each radio; empty: it was never heard
  Eigen::ArrayXf all_silent_;  // log probability of hearing no radio
};

}  // namespace sfw
