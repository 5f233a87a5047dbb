#include "tomography/sparse_sums.h"

#include <algorithm>

namespace sfw {
namespace {

constexpr std::size_t kBlock = 65536;  // terms: as many as 16 bits can number

}  // namespace

SparseSums::SparseSums(std::size_t sums, std::size_t terms, const Choice& choice) : size_(sums) {
  for (std::size_t first = 0; first < terms; first += kBlock) {
    blocks_.push_back(blockOf(sums, first, choice));
  }
}

SparseSums::Block SparseSums::blockOf(std::size_t sums, std::size_t first_term,
                                      const Choice& choice) {
  const auto visit_block = [&](auto&& visit) {
    for (std::size_t i = 0; i < choice.term.size(); ++i) {
      const std::size_t term = static_cast<std::size_t>(choice.term[i]) - first_term;
      if (term < kBlock) {  // those before the block wrap round to huge numbers
        visit(static_cast<std::size_t>(choice.sum[i]), static_cast<std::uint16_t>(term));
      }
    }
  };
  std::vector<std::uint32_t> count(sums, 0);
  visit_block([&](std::size_t sum, std::uint16_t) { ++count[sum]; });
  Block block;
  for (std::uint32_t i = 0; i < sums; ++i) {
    if (count[i] > 0) {
      block.sums.push_back({i, count[i]});
    }
  }
  std::stable_sort(block.sums.begin(), block.sums.end(),
                   [](const auto& a, const auto& b) { return a.terms < b.terms; });
  std::vector<std::size_t> next(sums, 0);  // place of each sum's next term
  std::size_t terms = 0;
  for (const Block::Sum& sum : block.sums) {
    next[sum.number] = terms;
    terms += sum.terms;
  }
  block.terms.resize(terms);
  visit_block([&](std::size_t sum, std::uint16_t term) { block.terms[next[sum]++] = term; });
  return block;
}

void SparseSums::of(const Eigen::VectorXf& terms, Eigen::VectorXf& sums) const {
  sums.setZero(static_cast<Eigen::Index>(size_));
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const float* const values = terms.data() + i * kBlock;
    const std::uint16_t* term = blocks_[i].terms.data();
    for (const Block::Sum& sum : blocks_[i].sums) {
      // Four partial sums are used, because each addition waits for the previous one.
      float a = 0.0F, b = 0.0F, c = 0.0F, d = 0.0F;
      std::uint32_t left = sum.terms;
      for (; left >= 4; left -= 4, term += 4) {
        a += values[term[0]];
        b += values[term[1]];
        c += values[term[2]];
        d += values[term[3]];
      }
      for (; left > 0; --left) {
        a += values[*term++];
      }
      sums[sum.number] += (a + b) + (c + d);
    }
  }
}

}  // namespace sfw
