#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sfw {

/// Sums of chosen terms, for many sums over the same terms again and again: a product with a sparse
/// matrix of ones.
///
/// Made for speed: short numbers halve the memory to pass through, and sums of as many terms come
/// one after another, as loops of a new length each time take processors twice as long.
class SparseSums {
 public:
  /// That terms[i] is one of those of sum sums[i]; in this order they are added up.
  struct Choice {
    std::vector<std::int32_t> sum;   ///< in [0, sums)
    std::vector<std::int32_t> term;  ///< in [0, terms)
  };

  SparseSums() = default;
  SparseSums(std::size_t sums, std::size_t terms, const Choice& choice);

  /// The same choice with sums and terms exchanged: the transposed matrix.
  static Choice transposed(Choice choice) {
    return {std::move(choice.term), std::move(choice.sum)};
  }

  /// Sets `sums` to those of `terms`. O(choices).
  void of(const Eigen::VectorXf& terms, Eigen::VectorXf& sums) const;

 private:
  /// Few enough terms that a short number tells them apart.
  struct Block {
    struct Sum {
      std::uint32_t number;
      std::uint32_t terms;
    };
    std::vector<Sum> sums;             // with any terms in the block, by how many
    std::vector<std::uint16_t> terms;  // of one sum after another, counted from the block's first
  };

  static Block blockOf(std::size_t sums, std::size_t first_term, const Choice& choice);

  std::size_t size_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace sfw
