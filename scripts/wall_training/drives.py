"""Drives of `sfw wall-drives`, and crops of them for training."""

import json
import sys

import numpy as np

CROP = 96  # cells
LINES = 512  # of each crop
LINES_OF_DRIVE = 4000
FEWEST_LINES = 50  # of a drive
POINTS = 61  # samples along each line
SHORTEST, LONGEST = 5, 30  # lines between two places [cells]
NEAR_PATH = 0.05  # the input path_distance at 0.1 m; walls nearer than that are no walls


class Channels:
    """Names of the channels of a drive's file, and the channels that change places with the axes."""

    def __init__(self, index):
        self.inputs, self.radio = index["inputs"], index["radio_inputs"]
        self.names = index["inputs"] + index["labels"]
        self.radio_numbers = [self.names.index(name) for name in self.radio]
        self.mirrored_x = self.exchanged([("_left", "_right")])
        self.mirrored_y = self.exchanged([("_below", "_above")])
        self.transposed = self.exchanged([("_left", "_below"), ("_right", "_above"),
                                          ("_along_x", "_along_y")])

    def exchanged(self, endings):
        def partner(name):
            for a, b in endings + [(b, a) for a, b in endings]:
                if name.endswith(a):
                    return name[:-len(a)] + b
            return name
        return [self.names.index(partner(name)) for name in self.names]

    def of(self, rasters, name):
        """One channel of rasters whose third axis from the end is that of channels."""
        return rasters[..., self.names.index(name), :, :]


class Drive:
    """Rasters (channel, row, column), and lines between places of the path, in cells."""

    def __init__(self, rasters, channels, random):
        self.rasters = rasters.astype(np.float16)
        on_path = np.argwhere(channels.of(rasters, "on_path") > 0)
        _, first = np.unique(on_path // 2, axis=0, return_index=True)  # one place in 0.2 m
        self.places = on_path[first]
        pairs = self.places[random.integers(0, len(first), (20 * LINES_OF_DRIVE, 2))]
        length = np.hypot(*(pairs[:, 0] - pairs[:, 1]).T)
        self.lines = pairs[(length > SHORTEST) & (length < LONGEST)][:LINES_OF_DRIVE].astype(np.int16)
        walls = ((channels.of(rasters, "true_walls") > 0)
                 & (channels.of(rasters, "path_distance") > NEAR_PATH))
        rows, columns = cells_of(self.lines)
        self.blocked = walls[rows, columns].any(1)


def cells_of(lines):
    """Rows and columns of the cells under samples of each line, from centre to centre."""
    along = np.linspace(0, 1, POINTS)[None, :, None]
    points = lines[:, None, 0] * (1 - along) + lines[:, None, 1] * along + 0.5
    return np.moveaxis(np.floor(points).astype(np.int64), 2, 0)


def spacing_of(lines):
    """Distance of the samples on each line, in cells."""
    return np.hypot(*(lines[:, 0] - lines[:, 1]).astype(np.float32).T) / (POINTS - 1)


def load(folder, validation_share, seed):
    """Drives for training and validation, their channels and the index. No building is in both."""
    index = json.loads((folder / "drives.json").read_text())
    channels, random = Channels(index), np.random.default_rng(seed)
    building = {drive["file"]: drive["plan"] if drive["plan"] != "generated" else str(drive["seed"])
                for drive in index["drives"]}
    buildings = sorted(set(building.values()))
    chosen = random.permutation(buildings)[:max(1, round(validation_share * len(buildings)))]
    parts = ([], [])
    for file, name in building.items():
        drive = Drive(np.load(folder / file), channels, random)
        if len(drive.lines) >= FEWEST_LINES:
            parts[name in chosen].append(drive)
    if not parts[0]:
        sys.exit("%s: has no drives to train with; make more with `sfw wall-drives`" % folder)
    return parts[0], parts[1], channels, index


def crop(drive, channels, without_radio, random):
    """A square of a drive around a place of its path, mirrored and transposed at random."""
    size = np.array(drive.rasters.shape[1:])
    corner = random.choice(drive.places) - CROP // 2 + random.integers(-24, 25, 2)
    corner = np.where(size > CROP, np.clip(corner, 0, np.maximum(size - CROP, 0)),
                      -random.integers(0, np.maximum(CROP - size, 0) + 1))
    low, high = np.maximum(corner, 0), np.minimum(corner + CROP, size)
    rasters = np.zeros((len(channels.names), CROP, CROP), np.float32)
    (top, left), (bottom, right) = low - corner, high - corner
    rasters[:, top:bottom, left:right] = drive.rasters[:, low[0]:high[0], low[1]:high[1]]
    lines = drive.lines - corner
    inside = ((lines >= 0) & (lines < CROP)).all((1, 2))
    lines, blocked = lines[inside], drive.blocked[inside]
    if random.random() < 0.5:
        rasters, lines = rasters[channels.mirrored_y, ::-1], lines * [-1, 1] + [CROP - 1, 0]
    if random.random() < 0.5:
        rasters, lines = rasters[channels.mirrored_x, :, ::-1], lines * [1, -1] + [0, CROP - 1]
    if random.random() < 0.5:
        rasters, lines = rasters[channels.transposed].transpose(0, 2, 1), lines[:, :, ::-1]
    if without_radio:
        rasters = rasters.copy()
        rasters[channels.radio_numbers] = 0
    chosen = random.permutation(len(lines))[:LINES]
    return rasters, lines[chosen], blocked[chosen]
