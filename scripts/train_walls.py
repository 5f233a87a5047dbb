#!/usr/bin/env python3
"""Trains the network of walls on simulated drives and writes its weights.

doc/method/network.md describes the training. It needs NumPy, PyTorch, and a folder that
`sfw wall-drives` wrote. Drives through a share of the buildings are kept for validation. The same
drives, options, versions and processor give the same weights on a CPU with one thread.
"""

import argparse
import json
import pathlib
import sys
import time

try:
    import numpy as np
    import torch
    from torch import nn
except ImportError as error:
    sys.exit("train_walls.py: %s; install NumPy and PyTorch: pip install numpy torch" % error)

from wall_training.drives import cells_of, crop, load, spacing_of
from wall_training.network import WallNetwork, read_network, write_network

LOG_ODDS_SCALE = 0.3  # of the inputs log_odds_* (src/walls/network_inputs.cpp)
WALL_EXPECTED = 0.7  # StripWallConfig::least_expected of src/walls/strip_walls.h
FEWEST_LINES = 20  # of each kind, in a drive that counts in the validation


def loss_of(network, crops, channels, line_weight, device):
    """The state of each cell, and whether a wall stands on each line between two places."""
    rasters = torch.from_numpy(np.stack([one[0] for one in crops])).to(device)
    output = network(rasters[:, :len(channels.inputs)])
    label = {name: channels.of(rasters, name) for name in
             ("free", "wall", "described", "footprint", "log_odds_straightened",
              "radio_log_odds_straightened")}
    belief = (label["log_odds_straightened"] + label["radio_log_odds_straightened"]) / LOG_ODDS_SCALE
    logits = torch.stack([output[:, 0] + 0.5 * belief, output[:, 1], output[:, 2]], 1)
    unseen = (1 - label["free"] - label["wall"]).clamp(min=0)
    states = torch.stack([label["free"], label["wall"], unseen], 1)
    entropy = -(states * torch.log_softmax(logits, 1)).sum(1)
    cells = (entropy * label["described"]).sum() / label["described"].sum()
    density = nn.functional.softplus(output[:, 3]) * (1 - label["footprint"])
    expected = torch.cat([sum_on_lines(density[i], one[1]) for i, one in enumerate(crops)]) + 1e-4
    blocked = torch.from_numpy(np.concatenate([one[2] for one in crops])).to(device).float()
    wall = torch.log(1 - torch.exp(-expected) + 1e-7)
    lines = -(blocked * wall - (1 - blocked) * expected).sum() / max(1, len(blocked))
    return cells + line_weight * lines


def sum_on_lines(density, lines):
    """The expected number of walls on each line."""
    rows, columns = (torch.from_numpy(part).to(density.device) for part in cells_of(lines))
    spacing = torch.from_numpy(spacing_of(lines)).to(density.device)
    return density[rows, columns].sum(1) * spacing


def area_under_curve(scores, positive):
    """The chance that a positive has a higher score than a negative; ties count half."""
    _, which, counts = np.unique(scores, return_inverse=True, return_counts=True)
    rank = (np.cumsum(counts) - (counts - 1) / 2)[which]
    count = positive.sum()
    return (rank[positive].mean() - (count + 1) / 2) / (len(positive) - count)


def validate(network, drives, channels, use_radio, device):
    """Means over the drives: AUC and F1 of walls on lines between two places."""
    areas, scores = [], []
    for drive in drives:
        if min(drive.blocked.sum(), (~drive.blocked).sum()) < FEWEST_LINES:
            continue
        rasters = drive.rasters.astype(np.float32)
        rasters[channels.radio_numbers] *= use_radio
        rows, columns = rasters.shape[1:]
        padded = np.pad(rasters[:len(channels.inputs)], ((0, 0), (0, -rows % 8), (0, -columns % 8)))
        with torch.no_grad():
            output = network(torch.from_numpy(padded)[None].to(device))[0, 3, :rows, :columns]
        footprint = torch.from_numpy(channels.of(rasters, "footprint")).to(device)
        density = nn.functional.softplus(output) * (1 - footprint)
        expected = sum_on_lines(density, drive.lines).cpu().numpy()
        found = expected > WALL_EXPECTED
        areas.append(area_under_curve(expected, drive.blocked))
        scores.append(2 * (found & drive.blocked).sum() / max(1, found.sum() + drive.blocked.sum()))
    if not areas:
        return {"drives": 0}
    return {"drives": len(areas), "auc": round(float(np.mean(areas)), 4),
            "f1": round(float(np.mean(scores)), 4)}


def figures_of(network, drives, channels, device):
    return {"with_radio": validate(network, drives, channels, True, device),
            "without_radio": validate(network, drives, channels, False, device)}


def average(mean, network, weight):
    """Moves the running mean of all weights towards the network's."""
    with torch.no_grad():
        for to, value in zip(mean.state_dict().values(), network.state_dict().values()):
            if value.is_floating_point():
                to.lerp_(value, weight)
            else:
                to.copy_(value)


def train(drives, channels, options, device):
    """The running mean of the weights over the last steps, which is better than the last ones."""
    torch.manual_seed(options.seed)
    random = np.random.default_rng(options.seed)
    network, mean = (WallNetwork(len(channels.inputs)).to(device) for _ in range(2))
    optimizer = torch.optim.AdamW(network.parameters(), options.rate, weight_decay=1e-3)
    start, recent = time.monotonic(), []
    for step in range(options.steps):
        decay = 0.5 + 0.5 * np.cos(np.pi * step / options.steps)
        optimizer.param_groups[0]["lr"] = options.rate * min(1, (step + 1) / 100) * decay + 1e-5
        crops = [crop(drives[random.integers(len(drives))], channels,
                      random.random() < options.without_radio, random) for _ in range(options.batch)]
        loss = loss_of(network, crops, channels, options.line_weight, device)
        optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimizer.step()
        average(mean, network, 1.0 if step < 500 else 0.002)
        recent.append(loss.item())
        if (step + 1) % 200 == 0 or step + 1 == options.steps:
            print("step %d of %d, %.0f s, loss %.4f" % (
                step + 1, options.steps, time.monotonic() - start, np.mean(recent[-200:])), flush=True)
    return mean.eval()


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("drives", type=pathlib.Path, help="folder of `sfw wall-drives`")
    parser.add_argument("--output", help="file for the weights (JSON)")
    parser.add_argument("--evaluate", metavar="FILE",
                        help="print the figures of these weights on the drives for validation instead")
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--batch", type=int, default=6, help="crops in each step")
    parser.add_argument("--rate", type=float, default=2.5e-3, help="learning rate")
    parser.add_argument("--line-weight", type=float, default=2.0, help="weight of the loss on lines")
    parser.add_argument("--without-radio", type=float, default=0.3, help="share of the crops")
    parser.add_argument("--validation", type=float, default=0.05, help="share of the buildings")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args(arguments)
    if (options.output is None) == (options.evaluate is None):
        parser.error("give either --output or --evaluate")
    return options


def main(arguments):
    options = parse(arguments)
    torch.set_num_threads(options.threads)
    torch.use_deterministic_algorithms(True, warn_only=True)
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    training, validation, channels, index = load(options.drives, options.validation, options.seed)
    print("%d drives to train, %d to validate" % (len(training), len(validation)), flush=True)
    if options.evaluate:
        network = read_network(options.evaluate, channels.inputs).to(device)
    else:
        network = train(training, channels, options, device)
    figures = figures_of(network, validation, channels, device)
    print(json.dumps(figures))
    if options.output:
        settings = {name: value for name, value in vars(options).items()
                    if name not in ("drives", "output", "evaluate")}
        made_by = {"drives": index["command"], "version": index["version"], "plans": index["plans"],
                   "training": "scripts/train_walls.py", "settings": settings,
                   "torch": torch.__version__, "device": device.type,
                   "drives_to_train": len(training), "validation": figures}
        write_network(options.output, network, channels.inputs, made_by)


if __name__ == "__main__":
    main(sys.argv[1:])
