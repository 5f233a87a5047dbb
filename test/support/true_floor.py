"""The true floor of a simulation, and places on it where a robot fits."""

import heapq
import math
import re

import numpy


class TrueFloor:
    """Reads a map of map_server.

    `free` are its free cells [row, column], the lowest row first. `open` are those in which the
    centre of a robot may stand: `clearance` [m] from everything that is not free.
    """

    def __init__(self, path, clearance):
        text = path.read_text()
        self.cell = float(re.search(r"resolution: *(\S+)", text).group(1))
        self.origin = [float(word) for word in
                       re.search(r"origin: *\[([^]]*)\]", text).group(1).split(",")[:2]]
        pixels = (path.parent / re.search(r"image: *(\S+)", text).group(1)).read_bytes()
        header = re.match(rb"P5\s+(?:#.*\s+)*(\d+)\s+(\d+)\s+255\s", pixels)
        width, height = int(header.group(1)), int(header.group(2))
        rows = numpy.frombuffer(pixels[header.end():], numpy.uint8).reshape(height, width)
        self.free = numpy.flipud(rows) == 254
        self.open = self.shrunk(clearance)

    def shrunk(self, by):
        reach = int(math.ceil(by / self.cell))
        padded = numpy.pad(self.free, reach)
        result = self.free.copy()
        height, width = self.free.shape
        for dy in range(-reach, reach + 1):
            for dx in range(-reach, reach + 1):
                if math.hypot(dx, dy) * self.cell <= by:
                    result &= padded[reach + dy:reach + dy + height, reach + dx:reach + dx + width]
        return result

    def place(self, cell):
        return (round(self.origin[0] + (cell[1] + 0.5) * self.cell, 3),
                round(self.origin[1] + (cell[0] + 0.5) * self.cell, 3))

    def cell_at(self, place):
        return (int((place[1] - self.origin[1]) / self.cell),
                int((place[0] - self.origin[0]) / self.cell))

    def is_free(self, place):
        y, x = self.cell_at(place)
        height, width = self.free.shape
        return 0 <= y < height and 0 <= x < width and bool(self.free[y, x])

    def random_place(self, random):
        """A place in the largest part of the floor that the robot can drive through."""
        cells = [tuple(cell) for cell in numpy.argwhere(self.open)]
        while True:
            cell = random.choice(cells)
            if len(self.distances(cell)) > len(cells) // 2:
                return self.place(cell)

    def neighbour(self, place, random):
        """A place one cell beside this one, into which the robot can look from there."""
        y, x = self.cell_at(place)
        steps = [(y + dy, x + dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if dy or dx]
        return self.place(random.choice([cell for cell in steps if self.open[cell]]))

    def distances(self, start):
        """Length of the shortest way [m] from a cell to each cell that can be reached."""
        best, queue = {start: 0.0}, [(0.0, start)]
        while queue:
            length, (y, x) = heapq.heappop(queue)
            if length > best[y, x]:
                continue
            for dy in (-1, 0, 1):
                for dx in (-1, 0, 1):
                    to = (y + dy, x + dx)
                    way = length + math.hypot(dx, dy) * self.cell
                    if (0 <= to[0] < self.open.shape[0] and 0 <= to[1] < self.open.shape[1]
                            and self.open[to] and way < best.get(to, math.inf)):
                        best[to] = way
                        heapq.heappush(queue, (way, to))
        return best

    def sees(self, a, b):
        """Whether the straight line between two places stays on free cells."""
        steps = int(math.dist(a, b) / self.cell * 4) + 1
        return all(self.free[self.cell_at((a[0] + (b[0] - a[0]) * i / steps,
                                           a[1] + (b[1] - a[1]) * i / steps))]
                   for i in range(steps + 1))

    def random_goal(self, random, start, nearest, farthest, longest, hidden):
        """A place by its straight distance and the length of its way [m].

        hidden: whether a wall stands between; None: either.
        """
        cells = numpy.argwhere(self.open)
        cell = min((tuple(c) for c in cells), key=lambda c: math.dist(self.place(c), start))
        ways = self.distances(cell)
        fitting = [self.place(c) for c, way in sorted(ways.items())
                   if way <= longest and nearest <= math.dist(self.place(c), start) <= farthest]
        random.shuffle(fitting)
        return next(g for g in fitting if hidden is None or hidden != self.sees(start, g))
