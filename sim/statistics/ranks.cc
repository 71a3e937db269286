#include "sim/statistics/ranks.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "controller/base/check.h"

namespace dockyard {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Estimate kUnknown{kNaN, {kNaN, kNaN}};

// What rounding leaves of a column of length 1 that the others explain.
constexpr double kNothing = 1e-10;

bool HasNaN(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
}

/// Ranks about their mean; these are halves of whole numbers, so the sums of squares are exact.
VectorXd Centred(const std::vector<double>& ranks) {
  const auto n = static_cast<Index>(ranks.size());
  return Eigen::Map<const VectorXd>(ranks.data(), n).array() - 0.5 * (double(n) + 1.0);
}

/// @param n  number of values, less those that a partial correlation spent on other inputs
Estimate WithInterval(double r, Index n, double confidence) {
  if (n < 4) return {r, {kNaN, kNaN}};
  const double z = std::atanh(r);
  const double half =
      NormalDeviate(confidence) * std::sqrt((1.0 + 0.5 * r * r) / (double(n) - 3.0));
  return {r, {std::tanh(z - half), std::tanh(z + half)}};
}

double CosineOf(const VectorXd& x, const VectorXd& y) {
  return std::clamp(x.dot(y) / (x.norm() * y.norm()), -1.0, 1.0);
}

/// What the other inputs leave of the columns, and how many inputs that took.
struct Residuals {
  MatrixXd columns;
  Index spent = 0;
};

Residuals WithoutOthers(const MatrixXd& columns, const std::vector<Index>& inputs, Index input) {
  Residuals left{columns, 0};
  if (inputs.size() < 2) return left;
  MatrixXd others(columns.rows(), static_cast<Index>(inputs.size()) - 1);
  Index to = 0;
  for (const Index from : inputs) {
    if (from != input) others.col(to++) = columns.col(from);
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(kNothing);
  qr.compute(others);
  left.spent = qr.rank();
  const MatrixXd turned = qr.householderQ().adjoint() * columns;
  left.columns = turned.bottomRows(columns.rows() - left.spent);
  return left;
}

}  // namespace

std::vector<double> Ranks(const std::vector<double>& values) {
  if (HasNaN(values)) return std::vector<double>(values.size(), kNaN);
  struct Placed {
    double value;
    std::size_t at;
  };
  std::vector<Placed> order;
  order.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) order.push_back({values[i], i});
  std::sort(order.begin(), order.end(),
            [](const Placed& a, const Placed& b) { return a.value < b.value; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    while (next < order.size() && order[next].value == order[first].value) ++next;
    const double shared = 0.5 * (double(first) + 1.0 + double(next));
    for (std::size_t i = first; i < next; ++i) ranks[order[i].at] = shared;
  }
  return ranks;
}

RankTable::RankTable(std::size_t rows, std::size_t columns)
    : ranks_(static_cast<Index>(rows), static_cast<Index>(columns)) {}

Index RankTable::Add(const std::vector<double>& ranks) {
  DOCKYARD_CHECK(static_cast<Index>(ranks.size()) == ranks_.rows());
  if (ranks.size() < 3 || HasNaN(ranks)) return kLeftOut;
  const VectorXd centred = Centred(ranks);
  const double squares = centred.squaredNorm();
  if (squares == 0.0) return kLeftOut;
  const auto place = static_cast<Index>(scale_.size());
  DOCKYARD_CHECK(place < ranks_.cols());
  ranks_.col(place) = centred.cast<float>();
  scale_.push_back(1.0 / std::sqrt(squares));
  return place;
}

void RankTable::AddInput(const std::vector<double>& ranks) {
  inputs_.push_back(Add(ranks));
  known_ = known_ && !HasNaN(ranks);
}

void RankTable::AddOutput(const std::vector<double>& ranks) { outputs_.push_back(Add(ranks)); }

/// Columns of length 1 with the same angles between them, in at most as many rows as there are
/// columns: the triangle of a QR decomposition, a block of rows at a time.
MatrixXd RankTable::Condensed() const {
  constexpr Index kBlock = 2048;
  const auto count = static_cast<Index>(scale_.size());
  const VectorXd scale = Eigen::Map<const VectorXd>(scale_.data(), count);
  MatrixXd triangle(0, count);
  for (Index from = 0; from < ranks_.rows(); from += kBlock) {
    const Index rows = std::min(kBlock, ranks_.rows() - from);
    MatrixXd stacked(triangle.rows() + rows, count);
    stacked.topRows(triangle.rows()) = triangle;
    stacked.bottomRows(rows) =
        ranks_.block(from, 0, rows, count).cast<double>() * scale.asDiagonal();
    if (stacked.rows() <= count) {
      triangle = stacked;
      continue;
    }
    const Eigen::HouseholderQR<MatrixXd> qr(stacked);
    triangle = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  }
  return triangle;
}

RankCorrelations RankTable::Correlate(double confidence) const {
  const std::vector<Estimate> unknown(inputs_.size(), kUnknown);
  RankCorrelations found{{outputs_.size(), unknown}, {outputs_.size(), unknown}};
  if (!known_) return found;
  std::vector<Index> varied;
  std::copy_if(inputs_.begin(), inputs_.end(), std::back_inserter(varied),
               [](Index place) { return place != kLeftOut; });
  const MatrixXd columns = Condensed();
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const Index x = inputs_[i];
    if (x == kLeftOut) continue;
    const Residuals left = WithoutOthers(columns, varied, x);
    const Index freedom = ranks_.rows() - left.spent;
    for (std::size_t o = 0; o < outputs_.size(); ++o) {
      const Index y = outputs_[o];
      if (y == kLeftOut) continue;
      found.spearman[o][i] =
          WithInterval(CosineOf(columns.col(x), columns.col(y)), ranks_.rows(), confidence);
      const VectorXd a = left.columns.col(x), b = left.columns.col(y);
      if (freedom < 3 || a.norm() < kNothing || b.norm() < kNothing) continue;
      found.partial[o][i] = WithInterval(CosineOf(a, b), freedom, confidence);
    }
  }
  return found;
}

}  // namespace dockyard
