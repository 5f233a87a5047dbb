#include "access_points/law_terms.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/function_versions.h"
#include "radio/path_loss.h"

namespace sfw {
namespace {

constexpr double kUsualRiseM = 0.8;  // from antenna to access point, where the height is unknown

using Row = ShadowingWhitener::Row<double>;

/// All terms but the logarithm, whose place gets the distance.
SFW_FUNCTION_VERSIONS
void setDistances(const double* x, const double* y, std::size_t bins, const double* at_x,
                  const double* at_y, double rise_m, double usual_rise_m, LawTerms* terms) {
  for (std::size_t i = 0; i < bins; ++i) {
    for (std::size_t lane = 0; lane < kPositionLanes; ++lane) {
      const double away_x = x[i] - at_x[lane];
      const double away_y = y[i] - at_y[lane];
      const double space = spaceDistance(away_x * away_x + away_y * away_y, rise_m);
      const double distance = std::sqrt(space * space + usual_rise_m * usual_rise_m);
      const double way_x = away_x / distance;
      const double way_y = away_y / distance;
      terms[i][0][lane] = distance;
      terms[i][1][lane] = distance;
      terms[i][2][lane] = way_x;
      terms[i][3][lane] = way_y;
      terms[i][4][lane] = way_x * way_x - way_y * way_y;
      terms[i][5][lane] = 2.0 * way_x * way_y;
    }
  }
}

/// Lanes in a register of the processor, or in several.
using Vector = double __attribute__((vector_size(sizeof(PositionLanes))));

/// These must be part of the function that calls them, which may use wider registers than they.
/// @{
[[gnu::always_inline]] inline void load(const PositionLanes& lanes, Vector& vector) {
  std::memcpy(&vector, lanes.data(), sizeof(vector));
}
[[gnu::always_inline]] inline void store(const Vector& vector, PositionLanes& lanes) {
  std::memcpy(lanes.data(), &vector, sizeof(vector));
}
/// @}

SFW_FUNCTION_VERSIONS
void whiten(const Row* rows, std::size_t count, const LawTerms* terms, LawTerms* white) {
  for (std::size_t i = 0; i < count; ++i) {
    const Row& row = rows[i];
    Vector sums[kLawTerms];
    for (std::size_t term = 0; term < kLawTerms; ++term) {
      Vector own;
      load(terms[row.index[0]][term], own);
      sums[term] = row.weight[0] * own;
    }
    for (std::size_t j = 1; j < row.index.size(); ++j) {
      for (std::size_t term = 0; term < kLawTerms; ++term) {
        Vector other;
        load(terms[row.index[j]][term], other);
        sums[term] += row.weight[j] * other;
      }
    }
    for (std::size_t term = 0; term < kLawTerms; ++term) {
      store(sums[term], white[i][term]);
    }
  }
}

/// Products of a factor with the factors behind it: the law's first term, the others, the signals.
using LaneProducts = std::array<std::array<PositionLanes, kLawTerms + 2>, kLawTerms + 2>;

/// Sums up the products of one term with the first term, with the signals, with itself and with the
/// terms behind it. All sums of one call fit the processor's registers.
template <std::size_t kTerm>
[[gnu::always_inline]] inline void multiplyTerm(const LawTerms* white, const double* ones,
                                                const double* signals, std::size_t bins,
                                                LaneProducts& products) {
  constexpr std::size_t kOthers = kLawTerms - kTerm;
  Vector with_ones{}, with_signals{}, with[kOthers]{};
  for (std::size_t i = 0; i < bins; ++i) {
    Vector own;
    load(white[i][kTerm], own);
    with_ones += ones[i] * own;
    with_signals += own * signals[i];
    for (std::size_t other = 0; other < kOthers; ++other) {
      Vector factor;
      load(white[i][kTerm + other], factor);
      with[other] += own * factor;
    }
  }
  store(with_ones, products[0][kTerm + 1]);
  store(with_signals, products[kTerm + 1][kLawTerms + 1]);
  for (std::size_t other = 0; other < kOthers; ++other) {
    store(with[other], products[kTerm + 1][kTerm + other + 1]);
  }
}

SFW_FUNCTION_VERSIONS
void multiply(const LawTerms* white, const double* ones, const double* signals, std::size_t bins,
              LaneProducts& products) {
  multiplyTerm<0>(white, ones, signals, bins, products);
  multiplyTerm<1>(white, ones, signals, bins, products);
  multiplyTerm<2>(white, ones, signals, bins, products);
  multiplyTerm<3>(white, ones, signals, bins, products);
  multiplyTerm<4>(white, ones, signals, bins, products);
  multiplyTerm<5>(white, ones, signals, bins, products);
}

}  // namespace

LawTermsAtBins::LawTermsAtBins(const AccessPointBins& access_point)
    : rise_m_(antennaToAccessPoint(access_point.height_m)),
      usual_rise_m_(access_point.height_m ? 0.0 : kUsualRiseM) {
  for (const RadioBin& bin : access_point.bins) {
    x_.push_back(bin.position.x());
    y_.push_back(bin.position.y());
  }
}

void LawTermsAtBins::at(const std::array<Position, kPositionLanes>& positions,
                        std::vector<LawTerms>& terms) const {
  std::array<double, kPositionLanes> x, y;
  for (std::size_t lane = 0; lane < kPositionLanes; ++lane) {
    x[lane] = positions[lane].x();
    y[lane] = positions[lane].y();
  }
  terms.resize(x_.size());
  setDistances(x_.data(), y_.data(), x_.size(), x.data(), y.data(), rise_m_, usual_rise_m_,
               terms.data());
  for (LawTerms& bin : terms) {
    for (std::size_t lane = 0; lane < kPositionLanes; ++lane) {
      bin[0][lane] = 10.0 / std::log(10.0) * std::log(bin[0][lane]);
    }
  }
}

std::array<LawProducts, kPositionLanes> productsOf(const std::vector<LawTerms>& terms,
                                                   const ShadowingWhitener& whitener,
                                                   const Eigen::VectorXd& white_ones,
                                                   const Eigen::VectorXd& white_signals,
                                                   std::vector<LawTerms>& white) {
  constexpr Eigen::Index kSignals = kLawTerms + 1;
  white.resize(terms.size());
  whiten(whitener.rows().data(), terms.size(), terms.data(), white.data());
  LaneProducts lanes;
  multiply(white.data(), white_ones.data(), white_signals.data(), white.size(), lanes);
  LawProducts fixed;  // those without any term of the position
  fixed.setZero();
  for (Eigen::Index i = 0; i < white_ones.size(); ++i) {
    fixed(0, 0) += white_ones[i] * white_ones[i];
    fixed(0, kSignals) += white_ones[i] * white_signals[i];
    fixed(kSignals, kSignals) += white_signals[i] * white_signals[i];
  }
  std::array<LawProducts, kPositionLanes> products;
  for (std::size_t lane = 0; lane < kPositionLanes; ++lane) {
    LawProducts& own = products[lane];
    own = fixed;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      for (std::size_t j = std::max<std::size_t>(i, 1); j < lanes.size(); ++j) {
        const bool is_fixed = (i == 0 || i == kLawTerms + 1) && j == kLawTerms + 1;
        if (!is_fixed) {
          own(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = lanes[i][j][lane];
        }
      }
    }
    own.triangularView<Eigen::StrictlyLower>() = own.transpose();
  }
  return products;
}

}  // namespace sfw
