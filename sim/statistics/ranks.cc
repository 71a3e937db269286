#include "sim/statistics/ranks.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

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
VectorXd CentredRanks(const std::vector<double>& values) {
  const std::vector<double> ranks = Ranks(values);
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

/// Columns of length 1 with the same angles between them, in as few rows as there are columns.
MatrixXd Condensed(const MatrixXd& columns) {
  if (columns.rows() <= columns.cols()) return columns;
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  return qr.matrixQR().topRows(columns.cols()).triangularView<Eigen::Upper>();
}

/// Column j with the last one, which is the output, given all the others.
/// @param n  rows before they were condensed
Estimate Partial(const MatrixXd& columns, Index j, Index n, double confidence) {
  MatrixXd others(columns.rows(), columns.cols() - 2);
  for (Index from = 0, to = 0; from + 1 < columns.cols(); ++from) {
    if (from != j) others.col(to++) = columns.col(from);
  }
  VectorXd x = columns.col(j), y = columns.col(columns.cols() - 1);
  Index spent = 0;
  if (others.cols() > 0) {
    Eigen::ColPivHouseholderQR<MatrixXd> qr;
    qr.setThreshold(kNothing);
    qr.compute(others);
    spent = qr.rank();
    const Index left = columns.rows() - spent;
    x = VectorXd(qr.householderQ().adjoint() * x).tail(left).eval();
    y = VectorXd(qr.householderQ().adjoint() * y).tail(left).eval();
  }
  const double length_x = x.norm(), length_y = y.norm();
  if (n - spent < 3 || length_x < kNothing || length_y < kNothing) return kUnknown;
  return WithInterval(std::clamp(x.dot(y) / (length_x * length_y), -1.0, 1.0), n - spent,
                      confidence);
}

}  // namespace

std::vector<double> Ranks(const std::vector<double>& values) {
  if (HasNaN(values)) return std::vector<double>(values.size(), kNaN);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    while (next < order.size() && values[order[next]] == values[order[first]]) ++next;
    const double shared = 0.5 * (double(first) + 1.0 + double(next));
    for (std::size_t i = first; i < next; ++i) ranks[order[i]] = shared;
  }
  return ranks;
}

Estimate Spearman(const std::vector<double>& x, const std::vector<double>& y, double confidence) {
  DOCKYARD_CHECK(x.size() == y.size());
  if (x.size() < 3 || HasNaN(x) || HasNaN(y)) return kUnknown;
  const VectorXd a = CentredRanks(x), b = CentredRanks(y);
  const double squares = a.squaredNorm() * b.squaredNorm();
  if (squares == 0.0) return kUnknown;
  return WithInterval(std::clamp(a.dot(b) / std::sqrt(squares), -1.0, 1.0), a.size(), confidence);
}

std::vector<Estimate> PartialRankCorrelations(const std::vector<std::vector<double>>& inputs,
                                              const std::vector<double>& output,
                                              double confidence) {
  std::vector<Estimate> correlations(inputs.size(), kUnknown);
  bool known = !HasNaN(output);
  for (const std::vector<double>& input : inputs) {
    DOCKYARD_CHECK(input.size() == output.size());
    known = known && !HasNaN(input);
  }
  const VectorXd y = CentredRanks(output);
  if (!known || y.size() < 3 || y.squaredNorm() == 0.0) return correlations;

  const Index n = y.size();
  MatrixXd columns(n, static_cast<Index>(inputs.size()) + 1);
  std::vector<std::size_t> varied;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const VectorXd x = CentredRanks(inputs[i]);
    if (x.squaredNorm() == 0.0) continue;
    columns.col(static_cast<Index>(varied.size())) = x.normalized();
    varied.push_back(i);
  }
  columns.col(static_cast<Index>(varied.size())) = y.normalized();
  columns.conservativeResize(n, static_cast<Index>(varied.size()) + 1);
  columns = Condensed(columns);
  for (std::size_t i = 0; i < varied.size(); ++i) {
    correlations[varied[i]] = Partial(columns, static_cast<Index>(i), n, confidence);
  }
  return correlations;
}

}  // namespace dockyard
