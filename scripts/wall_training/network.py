"""The network of walls in PyTorch, and its file."""

import json
import pathlib
import sys

import torch
from torch import nn

FORMAT = 1  # kWallNetworkFormat of src/walls/wall_network.h
# Each layer: name, edge of its kernel, inputs (the layer whose outputs it takes), outputs.
LAYERS = [("fine0", 1, None, 10), ("fine1", 3, "fine0", 12),
          ("middle0", 3, "fine1", 24), ("middle1", 3, "middle0", 24),
          ("coarse0", 3, "middle1", 40), ("coarse1", 3, "coarse0", 40),
          ("coarsest0", 3, "coarse1", 48), ("coarsest1", 3, "coarsest0", 48),
          ("up_coarse", 3, "coarsest1 coarse1", 20), ("up_middle", 3, "up_coarse middle1", 16),
          ("up_fine", 3, "up_middle fine1", 10), ("output", 1, "up_fine", 4)]


class WallNetwork(nn.Module):
    """The U-Net of src/walls/wall_network.h. Each layer is a convolution and a normalisation."""

    def __init__(self, inputs, normalised=True):
        super().__init__()
        outputs = {name: count for name, _, _, count in LAYERS}
        self.blocks = nn.ModuleDict()
        for name, edge, sources, count in LAYERS:
            channels = sum(outputs[source] for source in sources.split()) if sources else inputs
            block = [nn.Conv2d(channels, count, edge, padding=edge // 2)]
            if normalised and name != "output":
                block.append(nn.BatchNorm2d(count, momentum=0.02))
            self.blocks[name] = nn.Sequential(*block)
        # At first: free space as the belief model says, and very few walls.
        nn.init.zeros_(self.blocks["output"][0].weight)
        self.blocks["output"][0].bias.data = torch.tensor([0.0, -1.0, 0.0, -4.0])

    def layers(self, names, x):
        for name in names.split():
            x = torch.relu(self.blocks[name](x))
        return x

    def forward(self, x):
        def joined(coarse, fine):
            return torch.cat([nn.functional.interpolate(coarse, scale_factor=2), fine], 1)
        pool = nn.functional.max_pool2d
        fine = self.layers("fine0 fine1", x)
        middle = self.layers("middle0 middle1", pool(fine, 2))
        coarse = self.layers("coarse0 coarse1", pool(middle, 2))
        coarsest = self.layers("coarsest0 coarsest1", pool(coarse, 2))
        up_coarse = self.layers("up_coarse", joined(coarsest, coarse))
        up_middle = self.layers("up_middle", joined(up_coarse, middle))
        return self.blocks["output"](self.layers("up_fine", joined(up_middle, fine)))

    def folded(self):
        """Weights and biases of each layer, with the normalisation folded into them."""
        for name, block in self.blocks.items():
            weights, bias = block[0].weight, block[0].bias
            if len(block) > 1:
                scale = block[1].weight / torch.sqrt(block[1].running_var + block[1].eps)
                weights = weights * scale[:, None, None, None]
                bias = (bias - block[1].running_mean) * scale + block[1].bias
            yield name, weights.detach().cpu(), bias.detach().cpu()


def read_network(file, inputs):
    network = WallNetwork(len(inputs), normalised=False)
    stored = json.loads(pathlib.Path(file).read_text())
    if stored["inputs"] != inputs:
        sys.exit("%s: has other inputs than the drives; make the drives with the release of this "
                 "network" % file)
    for block, layer in zip(network.blocks.values(), stored["layers"]):
        block[0].weight.data = torch.tensor(layer["weights"]).view_as(block[0].weight)
        block[0].bias.data = torch.tensor(layer["bias"])
    return network.eval()


def write_network(file, network, inputs, made_by):
    def numbers(values):
        return "[" + ",".join("%.4g" % value for value in values.flatten().tolist()) + "]"
    layers = ['  {"name": "%s", "edge": %d,\n   "weights": %s,\n   "bias": %s}'
              % (name, weights.shape[2], numbers(weights), numbers(bias))
              for name, weights, bias in network.folded()]
    pathlib.Path(file).write_text('{"format": %d,\n "made_by": %s,\n "inputs": %s,\n "layers": [\n%s]}\n'
                                  % (FORMAT, json.dumps(made_by), json.dumps(inputs),
                                     ",\n".join(layers)))
