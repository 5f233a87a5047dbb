#include "tomography/line_rays.h"

#include <algorithm>
#include <utility>

namespace sfw {

Unknowns::Unknowns(const std::vector<LineLattice>& lattices) {
  std::int64_t slots = 0;
  for (std::size_t i = 0; i < lattices.size(); ++i) {
    const GridGeometry& geometry = lattices[i].geometry;
    const auto cells = static_cast<std::int64_t>(geometry.size());
    blocks_.push_back({{i, true}, slots, geometry.height(), slots + cells});
    blocks_.push_back({{i, false}, slots + cells, geometry.width(), slots + 2 * cells});
    slots += 2 * cells;
  }
  number_.assign(static_cast<std::size_t>(slots), kNone);
}

void Unknowns::number() {
  for (std::size_t slot = 0; slot < number_.size(); ++slot) {
    if (number_[slot] != kNone) {
      number_[slot] = static_cast<std::int32_t>(slots_.size());
      slots_.push_back(static_cast<std::int32_t>(slot));
    }
  }
}

Eigen::ArrayXf Unknowns::continued() const {
  const std::size_t pairs = std::max<std::size_t>(slots_.size(), 1) - 1;
  Eigen::ArrayXf continued = Eigen::ArrayXf::Zero(static_cast<Eigen::Index>(pairs));
  forEachSlot([&](std::size_t i, const Block& block, std::int64_t offset) {
    const bool line_ends = (offset + 1) % block.along == 0;
    if (i < pairs && !line_ends && slots_[i + 1] == slots_[i] + 1) {
      continued[static_cast<Eigen::Index>(i)] = 1.0F;
    }
  });
  return continued;
}

namespace {

/// At least as many pieces of wall as all rays cross.
std::size_t mostCrossings(const std::vector<LineLattice>& lattices,
                          const std::vector<AccessPointBins>& access_points) {
  double lines = 0.0;
  for (const LineLattice& lattice : lattices) {
    for (const AccessPointBins& one : access_points) {
      const Position from = lattice.toLattice(one.position);
      for (const RadioBin& bin : one.bins) {
        const Position way = lattice.toLattice(bin.position) - from;
        lines += way.cwiseAbs().sum() / lattice.geometry.resolution() + 2.0;
      }
    }
  }
  return static_cast<std::size_t>(lines);
}

}  // namespace

Rays::Rays(const std::vector<LineLattice>& lattices,
           const std::vector<AccessPointBins>& access_points, const std::vector<Mask>& driven,
           const std::atomic<bool>& stop)
    : unknowns_(lattices) {
  SparseSums::Choice crossed;  // slots by ray
  const std::size_t most = mostCrossings(lattices, access_points);
  crossed.sum.reserve(most);
  crossed.term.reserve(most);
  for (const AccessPointBins& one : access_points) {
    for (const RadioBin& bin : one.bins) {
      if (stop) {
        return;
      }
      const auto ray = static_cast<std::int32_t>(size_++);
      for (std::size_t i = 0; i < lattices.size(); ++i) {
        forEachLine(lattices[i].geometry, lattices[i].toLattice(one.position),
                    lattices[i].toLattice(bin.position), [&](bool walls_along_y, Cell cell) {
                      if (driven[i][cell] == 0) {
                        const std::int32_t slot = unknowns_.slot({i, walls_along_y}, cell);
                        unknowns_.add(slot);
                        crossed.sum.push_back(ray);
                        crossed.term.push_back(slot);
                      }
                    });
      }
    }
  }
  unknowns_.number();
  for (std::int32_t& slot : crossed.term) {
    slot = unknowns_.in(slot);
  }
  along_ = SparseSums(size_, unknowns_.size(), crossed);
  spread_ = SparseSums(unknowns_.size(), size_, SparseSums::transposed(std::move(crossed)));
}

}  // namespace sfw
