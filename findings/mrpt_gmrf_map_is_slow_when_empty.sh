#!/usr/bin/env bash
# Shows that MRPT 2.5.8 needs long for maps of WiFi signals of its kind mrGMRF_SD, even empty ones.
#
# CWirelessPowerGridMap2D(mrGMRF_SD, ...) is a Gaussian Markov random field with sparse factors, so one
# would guess that thousands of cells are easy. But its constructor and each reading solve the whole
# field. CPU time grows with about the power 3.5 of the number of cells. One machine took .45 s for an
# empty map of 20 x 20 cells, 7.8 s for 30 x 30, and 60 s for 40 x 40, which is 4 x 4 m. A reading takes
# longer still. The kind mrKernelDM makes 400 x 400 cells in less time than this one makes 20 x 20.
#
# Usage: mrpt_gmrf_map_is_slow_when_empty.sh
# Exits 0 if the time grows so, 1 if it does not, 2 if it cannot be run. mrpt.bash says what it needs.
set -euo pipefail

# shellcheck source=findings/mrpt.bash
source "$(dirname "${BASH_SOURCE[0]}")/mrpt.bash"

fetch_mrpt

cat > gmrf.cpp <<'CPP'
#include <mrpt/maps/CWirelessPowerGridMap2D.h>

#include <cstdio>
#include <ctime>

using namespace mrpt::maps;

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// CPU time of an empty map and of one reading [s]; cells have 0.1 m.
double timeOf(const char* name, CRandomFieldGridMap2D::TMapRepresentation kind, int cells) {
  const double start = cpuSeconds();
  CWirelessPowerGridMap2D map(kind, 0.0, 0.1 * cells, 0.0, 0.1 * cells, 0.1);
  const double made = cpuSeconds();
  map.insertIndividualReading(0.5, {1.0, 1.0}, true);
  std::printf("%s, %d x %d cells: empty %.3f s, one reading %.3f s\n", name, cells, cells,
              made - start, cpuSeconds() - made);
  std::fflush(stdout);
  return made - start;
}

int main() {
  const double kernel = timeOf("mrKernelDM", CRandomFieldGridMap2D::mrKernelDM, 400);
  const double small = timeOf("mrGMRF_SD", CRandomFieldGridMap2D::mrGMRF_SD, 20);
  const double large = timeOf("mrGMRF_SD", CRandomFieldGridMap2D::mrGMRF_SD, 28);
  std::printf("twice the cells take %.1f times as long\n", large / small);
  return kernel < small && large > 4.0 * small ? 0 : 1;
}
CPP
build_with_mrpt gmrf

# MRPT writes to both streams, too.
if ./gmrf > seen 2> log; then
  grep -E 'mrKernelDM|mrGMRF_SD,|take' seen
  echo 'All is as described at the top of this script.'
else
  cat seen log >&2
  echo 'MRPT behaves otherwise than described at the top of this script: an empty map is fast.' >&2
  exit 1
fi
