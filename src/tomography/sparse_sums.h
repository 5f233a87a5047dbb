#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sfw {

/// Product with a sparse matrix of zeros and ones: each result is the sum of some of the terms.
///
/// It is fast for many products with one matrix. Indices of 16 bits halve the memory traffic. Sums
/// of equally many terms are stored together, because loops of unpredictable length take twice as
/// long (doc/results/own_code.md).
class SparseSums {
 public:
  /// The ones of the matrix: term[i] is added to sum[i], in this order.
  struct Choice {
    std::vector<std::int32_t> sum;   ///< in [0, sums)
    std::vector<std::int32_t> term;  ///< in [0, terms)
  };

  /// No sums.
  SparseSums() = default;

  /// @param sums,terms  rows and columns of the matrix
  SparseSums(std::size_t sums, std::size_t terms, const Choice& choice);

  /// The transposed matrix.
  static Choice transposed(Choice choice) {
    return {std::move(choice.term), std::move(choice.sum)};
  }

  /// Sets `sums` to the product of the matrix with `terms`. O(ones).
  void of(const Eigen::VectorXf& terms, Eigen::VectorXf& sums) const;

 private:
  /// The part of the matrix for at most 65536 terms, as many as 16 bits can number.
  struct Block {
    struct Sum {
      std::uint32_t number;
      std::uint32_t terms;
    };
    std::vector<Sum> sums;             // those with terms in the block, by number of terms
    std::vector<std::uint16_t> terms;  // of one sum after another, counted from the block's first
  };

  static Block blockOf(std::size_t sums, std::size_t first_term, const Choice& choice);

  std::size_t size_ = 0;
  std::vector<Block> blocks_;
};

}  // namespace sfw
