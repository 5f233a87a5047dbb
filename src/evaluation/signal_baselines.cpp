#include "evaluation/signal_baselines.h"

#include <mrpt/maps/CWirelessPowerGridMap2D.h>

#include "localization/signal_field.h"

namespace sfw {

std::vector<double> predictByKriging(const std::vector<Sample>& known,
                                     const std::vector<Position>& positions) {
  return SignalField(known, learnConstantLaw(known)).predict(positions).mean_dbm;
}

std::vector<double> predictByMrpt(const std::vector<Sample>& known,
                                  const std::vector<Position>& positions, double sigma_m) {
  using mrpt::maps::CWirelessPowerGridMap2D;
  constexpr double kCellM = 0.25;
  constexpr double kMarginM = 1.0;
  constexpr double kCutoffSigmas = 4.0;
  Box box;
  for (const Sample& sample : known) {
    box.extend(sample.antenna_in_map);
  }
  for (const Position& position : positions) {
    box.extend(position);
  }
  const Position low = box.min() - Position(kMarginM, kMarginM);
  const Position high = box.max() + Position(kMarginM, kMarginM);
  CWirelessPowerGridMap2D map(CWirelessPowerGridMap2D::mrKernelDMV, low.x(), high.x(), low.y(),
                              high.y(), kCellM);
  map.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  map.insertionOptions.sigma = static_cast<float>(sigma_m);
  map.insertionOptions.cutoffRadius = static_cast<float>(kCutoffSigmas * sigma_m);
  for (const Sample& sample : known) {
    map.insertIndividualReading(sample.rssi_dbm,
                                {sample.antenna_in_map.x(), sample.antenna_in_map.y()});
  }
  std::vector<double> predicted_dbm;
  for (const Position& position : positions) {
    double rssi_dbm = 0.0;
    double variance = 0.0;
    map.predictMeasurement(position.x(), position.y(), rssi_dbm, variance, false,
                           CWirelessPowerGridMap2D::gimBilinear);
    predicted_dbm.push_back(rssi_dbm);
  }
  return predicted_dbm;
}

}  // namespace sfw
