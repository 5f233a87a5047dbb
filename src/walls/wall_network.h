#pragma once

#include <array>
#include <atomic>
#include <string>
#include <vector>

#include "walls/channels.h"
#include "walls/layers.h"
#include "walls/row_source.h"

namespace sfw {

/// A convolutional network that says where walls stand. It sees rasters of a drive in the building
/// frame, on cells of 0.1 m. It has the form of a U-Net (Ronneberger et al. 2015): three levels of
/// coarser rasters, and joints from each level to the way back. Immutable.
class WallNetwork {
 public:
  /// Channels of the output, for each cell.
  enum Output : std::size_t {
    kFree,     ///< logit of free space, without the log odds of the belief model
    kWall,     ///< logit of a wall
    kUnseen,   ///< logit of space that a lidar would not see from the path
    kDensity,  ///< softplus of it is the expected number of walls in the cell
    kOutputs
  };

  /// The convolutions in the order of their use. The last one has no activation.
  enum Layer : std::size_t {
    kFine0,
    kFine1,
    kMiddle0,
    kMiddle1,
    kCoarse0,
    kCoarse1,
    kCoarsest0,
    kCoarsest1,
    kUpCoarse,
    kUpMiddle,
    kUpFine,
    kOutput,
    kLayers
  };

  /// @param inputs  names of the rasters, in order
  /// @throw std::invalid_argument if the layers do not fit each other or the inputs.
  WallNetwork(std::vector<std::string> inputs, std::array<Convolution, kLayers> layers);

  const std::vector<std::string>& inputs() const { return inputs_; }

  /// Applies the network.
  /// @param rasters  one channel for each of inputs(), of any size
  /// @param stop     polled; when it turns true the result is incomplete
  /// @return kOutputs channels of the same size
  /// @throw std::invalid_argument if the number of channels is another.
  Channels apply(const RowSource& rasters, const std::atomic<bool>& stop) const;

 private:
  Channels convolved(Layer layer, const RowSource& input, const std::atomic<bool>& stop) const;

  std::vector<std::string> inputs_;
  std::array<Convolution, kLayers> layers_;
};

/// Number of the format of network files. A file of another format is refused.
constexpr int kWallNetworkFormat = 1;

/// Reads a network from JSON: `{format, inputs: [NAME], layers: [{edge, weights, bias}]}`. Other
/// keys are for people: `made_by` says how the network was trained.
/// @param name  of the file, for messages
/// @throw InputError with the name of the file, the part that is missing or malformed, and a
/// remedy.
WallNetwork parseWallNetwork(const std::string& json, const std::string& name);

/// Returns the network that the package ships: config/wall_network.json at the time of the build.
WallNetwork shippedWallNetwork();

}  // namespace sfw
