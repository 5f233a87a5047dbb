#include "output/octomap_columns.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "grid/for_each_cell.h"

namespace sfw {
namespace {

using Node = octomap::OcTreeNode;

constexpr int kDepth = 16;  // of every OctoMap: levels below the root
constexpr unsigned kChildren = 8;

/// OctoMap can make a root only together with a voxel at full depth.
class RootedTree : public octomap::OcTree {
 public:
  using octomap::OcTree::OcTree;

  Node* makeRoot() {
    root = new Node();  // the tree deletes it
    ++tree_size;
    size_changed = true;
    return root;
  }
};

/// The common properties of the columns of a square block of cells.
struct Block {
  std::int32_t most = 0;   // layers
  std::int32_t least = 0;  // layers
  float log_odds = 0.0F;   // of the first column
  bool alike = true;       // of all columns

  void join(const Block& other) {
    most = std::max(most, other.most);
    least = std::min(least, other.least);
    alike = alike && other.alike && log_odds == other.log_odds;
  }
};

/// The blocks of cells of 1, 2, 4, ... cells a side, as the tree divides them.
class Blocks {
 public:
  Blocks(const Grid<Column>& columns, Cell first)
      : first_{first.x + kOctomapReach, first.y + kOctomapReach} {
    levels_.reserve(kDepth + 1);
    levels_.emplace_back(
        GridGeometry(1.0, Position::Zero(), columns.geometry.width(), columns.geometry.height()));
    for (std::size_t i = 0; i < columns.cells.size(); ++i) {
      const Column& column = columns.cells[i];
      levels_[0].cells[i] = {column.layers, column.layers, column.log_odds, true};
    }
    for (int level = 1; level <= kDepth; ++level) {
      levels_.push_back(joined(level));
    }
  }

  /// The summary of the block with these numbers, of 2^level cells a side.
  Block at(int level, std::int64_t x, std::int64_t y) const {
    const Grid<Block>& blocks = levels_[static_cast<std::size_t>(level)];
    const Cell c{x - (first_.x >> level), y - (first_.y >> level)};
    return blocks.geometry.contains(c) ? blocks[c] : Block();
  }

 private:
  Grid<Block> joined(int level) const {
    const GridGeometry& finest = levels_[0].geometry;
    const std::int64_t x = first_.x >> level;
    const std::int64_t y = first_.y >> level;
    Grid<Block> blocks(GridGeometry(1.0, Position::Zero(),
                                    ((first_.x + finest.width() - 1) >> level) - x + 1,
                                    ((first_.y + finest.height() - 1) >> level) - y + 1));
    forEachCell(blocks.geometry, [&](Cell c) {
      const std::int64_t left = 2 * (x + c.x);
      const std::int64_t low = 2 * (y + c.y);
      Block block = at(level - 1, left, low);
      block.join(at(level - 1, left + 1, low));
      block.join(at(level - 1, left, low + 1));
      block.join(at(level - 1, left + 1, low + 1));
      blocks[c] = block;
    });
    return blocks;
  }

  Cell first_;  // numbered as the tree numbers voxels
  std::vector<Grid<Block>> levels_;
};

class Builder {
 public:
  Builder(const Blocks& blocks, octomap::OcTree& tree) : blocks_(blocks), tree_(tree) {}

  /// Fills the node of 2^level voxels a side with these numbers; something is in it.
  void fill(Node* node, int level, std::int64_t x, std::int64_t y, std::int64_t z) {
    const Block block = blocks_.at(level, x, y);
    if (block.alike && block.least >= ((z + 1) << level) - kOctomapReach) {
      node->setLogOdds(block.log_odds);
      return;
    }
    for (unsigned i = 0; i < kChildren; ++i) {
      const std::int64_t child_x = 2 * x + (i & 1U);
      const std::int64_t child_y = 2 * y + ((i >> 1U) & 1U);
      const std::int64_t child_z = 2 * z + (i >> 2U);
      const std::int64_t floor = (child_z << (level - 1)) - kOctomapReach;
      if (floor >= 0 && blocks_.at(level - 1, child_x, child_y).most > floor) {
        fill(tree_.createNodeChild(node, i), level - 1, child_x, child_y, child_z);
      }
    }
    node->setLogOdds(node->getMaxChildLogOdds());
  }

 private:
  const Blocks& blocks_;
  octomap::OcTree& tree_;
};

/// Whether all voxels of a node are known and occupied, or all known and free.
bool isWhole(const octomap::OcTree& tree, const Node& node, bool occupied) {
  if (!tree.nodeHasChildren(&node)) {
    return tree.isNodeOccupied(node) == occupied;
  }
  for (unsigned i = 0; i < kChildren; ++i) {
    if (!tree.nodeChildExists(&node, i) || !isWhole(tree, *tree.getNodeChild(&node, i), occupied)) {
      return false;
    }
  }
  return true;
}

void copyCertain(const octomap::OcTree& tree, const Node& node, octomap::OcTree& copy,
                 Node* copied) {
  const bool occupied = tree.isNodeOccupied(node);
  if (isWhole(tree, node, occupied)) {
    copied->setLogOdds(occupied ? tree.getClampingThresMaxLog() : tree.getClampingThresMinLog());
    return;
  }
  for (unsigned i = 0; i < kChildren; ++i) {
    if (tree.nodeChildExists(&node, i)) {
      copyCertain(tree, *tree.getNodeChild(&node, i), copy, copy.createNodeChild(copied, i));
    }
  }
  copied->setLogOdds(copied->getMaxChildLogOdds());
}

}  // namespace

std::unique_ptr<octomap::OcTree> treeOfColumns(const Grid<Column>& columns, Cell first) {
  auto tree = std::make_unique<RootedTree>(columns.geometry.resolution());
  const Blocks blocks(columns, first);
  if (blocks.at(kDepth, 0, 0).most > 0) {
    Builder(blocks, *tree).fill(tree->makeRoot(), kDepth, 0, 0, 0);
  }
  return tree;
}

std::unique_ptr<octomap::OcTree> mostLikely(const octomap::OcTree& tree) {
  auto copy = std::make_unique<RootedTree>(tree.getResolution());
  if (tree.getRoot() != nullptr) {
    copyCertain(tree, *tree.getRoot(), *copy, copy->makeRoot());
  }
  return copy;
}

}  // namespace sfw
