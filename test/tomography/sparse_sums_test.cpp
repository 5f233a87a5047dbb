#include "tomography/sparse_sums.h"

#include <gtest/gtest.h>

#include <utility>

#include "base/random.h"

namespace sfw {
namespace {

Eigen::VectorXf sumsOf(const SparseSums& sums, const Eigen::VectorXf& terms) {
  Eigen::VectorXf result;
  sums.of(terms, result);
  return result;
}

TEST(SparseSums, AddUpWhatWasChosen) {
  const SparseSums::Choice choice{{0, 2, 0, 2, 2, 2, 2}, {1, 0, 3, 1, 2, 3, 0}};
  const Eigen::VectorXf terms = Eigen::Vector4f(1.0F, 10.0F, 100.0F, 1000.0F);
  EXPECT_EQ(sumsOf(SparseSums(3, 4, choice), terms), Eigen::Vector3f(1010.0F, 0.0F, 1112.0F));
  const SparseSums back(4, 3, SparseSums::transposed(choice));
  EXPECT_EQ(sumsOf(back, Eigen::Vector3f(1.0F, 10.0F, 100.0F)),
            Eigen::Vector4f(200.0F, 101.0F, 100.0F, 101.0F));
}

TEST(SparseSums, AreEmptyWithoutSumsTermsOrChoices) {
  EXPECT_EQ(sumsOf(SparseSums(), Eigen::VectorXf()).size(), 0);
  EXPECT_EQ(sumsOf(SparseSums(2, 0, {}), Eigen::VectorXf()), Eigen::Vector2f(0.0F, 0.0F));
  EXPECT_EQ(sumsOf(SparseSums(0, 2, {}), Eigen::Vector2f(1.0F, 2.0F)).size(), 0);
}

TEST(SparseSums, AddUpMoreTermsThanShortNumbersTellApart) {
  constexpr std::size_t kSums = 7, kTerms = 200'001;
  Random random(1, 1, 0);
  SparseSums::Choice choice;
  Eigen::VectorXf expected = Eigen::VectorXf::Zero(kSums);
  Eigen::VectorXf terms(kTerms);
  for (Eigen::Index i = 0; i < terms.size(); ++i) {
    terms[i] = static_cast<float>(i % 5);  // sums of small whole numbers are exact
  }
  for (int i = 0; i < 3000; ++i) {
    const auto sum = static_cast<std::int32_t>(random.uniform(0.0, kSums));
    const auto term = static_cast<std::int32_t>(random.uniform(0.0, kTerms));
    choice.sum.push_back(sum);
    choice.term.push_back(term);
    expected[sum] += terms[term];
  }
  for (const std::int32_t edge : {0, 65535, 65536, 131071, 131072, 200'000}) {
    choice.sum.push_back(3);
    choice.term.push_back(edge);
    expected[3] += terms[edge];
  }
  EXPECT_EQ(sumsOf(SparseSums(kSums, kTerms, choice), terms), expected);
}

}  // namespace
}  // namespace sfw
