#include "walls/wall_network.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr std::size_t kLevels = 3;                // below the finest one
constexpr std::size_t kMultiple = 1U << kLevels;  // of the rasters' sizes

std::size_t roundedUp(std::size_t size) { return (size + kMultiple - 1) / kMultiple * kMultiple; }

/// Copies the cells that two rasters share; other cells of the target keep their values.
void copyShared(const Channels& from, Channels& to) {
  const std::size_t height = std::min(from.height(), to.height());
  const std::size_t width = std::min(from.width(), to.width());
  for (std::size_t c = 0; c < from.count(); ++c) {
    for (std::size_t y = 0; y < height; ++y) {
      std::copy_n(from.row(c, y), width, to.row(c, y));
    }
  }
}

void requireFit(const Convolution& layer, std::size_t inputs) {
  const std::size_t kernel = layer.edge * layer.edge;
  if (layer.inputs != inputs || (layer.edge != 1 && layer.edge != 3) ||
      layer.weights.size() != layer.inputs * layer.outputs * kernel ||
      layer.bias.size() != layer.outputs || layer.outputs == 0) {
    throw std::invalid_argument("the layers of the network do not fit each other");
  }
}

Convolution toConvolution(const nlohmann::json& layer) {
  Convolution convolution;
  convolution.edge = layer.at("edge").get<std::size_t>();
  convolution.weights = layer.at("weights").get<std::vector<float>>();
  convolution.bias = layer.at("bias").get<std::vector<float>>();
  convolution.outputs = convolution.bias.size();
  const std::size_t per_input = convolution.outputs * convolution.edge * convolution.edge;
  convolution.inputs = per_input == 0 ? 0 : convolution.weights.size() / per_input;
  return convolution;
}

}  // namespace

WallNetwork::WallNetwork(std::vector<std::string> inputs, std::array<Convolution, kLayers> layers)
    : inputs_(std::move(inputs)), layers_(std::move(layers)) {
  const auto outputs = [&](Layer layer) { return layers_[layer].outputs; };
  requireFit(layers_[kFine0], inputs_.size());
  for (const Layer layer :
       {kFine1, kMiddle0, kMiddle1, kCoarse0, kCoarse1, kCoarsest0, kCoarsest1}) {
    requireFit(layers_[layer], layers_[layer - 1].outputs);
  }
  requireFit(layers_[kUpCoarse], outputs(kCoarsest1) + outputs(kCoarse1));
  requireFit(layers_[kUpMiddle], outputs(kUpCoarse) + outputs(kMiddle1));
  requireFit(layers_[kUpFine], outputs(kUpMiddle) + outputs(kFine1));
  requireFit(layers_[kOutput], outputs(kUpFine));
  if (outputs(kOutput) != kOutputs) {
    throw std::invalid_argument("the last layer of the network has another number of outputs");
  }
}

Channels WallNetwork::convolved(Layer layer, const RowSource& input,
                                const std::atomic<bool>& stop) const {
  if (stop) {
    return Channels(layers_[layer].outputs, input.height, input.width);
  }
  return convolve(input, layers_[layer], layer == kOutput ? Activation::kNone : Activation::kRelu);
}

Channels WallNetwork::apply(const RowSource& rasters, const std::atomic<bool>& stop) const {
  const auto convolved = [&](Layer layer, const RowSource& input) {
    return this->convolved(layer, input, stop);
  };
  const auto twice = [&](Layer first, Layer second, const RowSource& input) {
    const Channels between = convolved(first, input);
    return convolved(second, rowsOf(between));
  };
  Channels result(kOutputs, rasters.height, rasters.width);
  const Channels fine =
      twice(kFine0, kFine1, padded(rasters, roundedUp(rasters.height), roundedUp(rasters.width)));
  const Channels middle = twice(kMiddle0, kMiddle1, maxPooled(fine));
  const Channels coarse = twice(kCoarse0, kCoarse1, maxPooled(middle));
  Channels up = twice(kCoarsest0, kCoarsest1, maxPooled(coarse));
  up = convolved(kUpCoarse, joined(upsampled(up), rowsOf(coarse)));
  up = convolved(kUpMiddle, joined(upsampled(up), rowsOf(middle)));
  up = convolved(kUpFine, joined(upsampled(up), rowsOf(fine)));
  copyShared(convolved(kOutput, rowsOf(up)), result);
  return result;
}

WallNetwork parseWallNetwork(const std::string& json, const std::string& name) {
  try {
    const nlohmann::json file = nlohmann::json::parse(json);
    if (file.at("format") != kWallNetworkFormat) {
      throw InputError(name + ": another format of networks; this release reads format " +
                       std::to_string(kWallNetworkFormat) + ", so train the network again");
    }
    const nlohmann::json& layers = file.at("layers");
    if (layers.size() != WallNetwork::kLayers) {
      throw InputError(name + ": layers must be a list of " + std::to_string(WallNetwork::kLayers) +
                       " layers");
    }
    std::array<Convolution, WallNetwork::kLayers> convolutions;
    for (std::size_t i = 0; i < convolutions.size(); ++i) {
      convolutions[i] = toConvolution(layers[i]);
    }
    return {file.at("inputs").get<std::vector<std::string>>(), std::move(convolutions)};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(name + ": not a network of walls: " + error.what());
  } catch (const std::invalid_argument& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace sfw
