#include "sim/draws/copula.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/normal.h"

namespace dockyard {
namespace {

// Variance that a key must have of its own, given those before it. Less is rounding or a mistake: a
// rank correlation of 1 - 1e-8 leaves 2e-8.
constexpr double kLeastOwnVariance = 1e-9;
// As near to 0 and 1 as OpenUnit() comes.
constexpr double kEnd = 0x1.0p-53;

/// The keys that have a correlation, in order.
std::vector<std::size_t> Members(std::size_t keys, const std::vector<RankCorrelation>& ranks) {
  std::set<std::size_t> members;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [first, second, rank] : ranks) {
    DOCKYARD_CHECK(first < keys && second < keys && first != second && std::abs(rank) <= 1.0);
    DOCKYARD_CHECK(pairs.insert(std::minmax(first, second)).second);
    members.insert({first, second});
  }
  return {members.begin(), members.end()};
}

Eigen::MatrixXd NormalCorrelations(const std::vector<std::size_t>& members,
                                   const std::vector<RankCorrelation>& ranks) {
  const auto place = [&](std::size_t key) {
    return std::lower_bound(members.begin(), members.end(), key) - members.begin();
  };
  const auto size = static_cast<Eigen::Index>(members.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  for (const auto& [first, second, rank] : ranks) {
    const double normal = 2.0 * std::sin(std::numbers::pi * rank / 6.0);
    matrix(place(first), place(second)) = matrix(place(second), place(first)) = normal;
  }
  return matrix;
}

}  // namespace

std::optional<Correlation> Correlation::FromRanks(std::size_t keys,
                                                  const std::vector<RankCorrelation>& ranks) {
  Correlation correlation;
  correlation.keys_ = keys;
  const std::vector<std::size_t> members = Members(keys, ranks);
  const Eigen::LLT<Eigen::MatrixXd> cholesky(NormalCorrelations(members, ranks));
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixXd lower = cholesky.matrixL();
  for (Eigen::Index i = lower.rows() - 1; i >= 0; --i) {
    if (lower(i, i) * lower(i, i) < kLeastOwnVariance) return std::nullopt;
    Row row{.key = members[i], .terms = {}};
    for (Eigen::Index j = 0; j <= i; ++j) {
      if (lower(i, j) != 0.0) row.terms.push_back({members[j], lower(i, j)});
    }
    if (row.terms.size() > 1) correlation.rows_.push_back(row);
  }
  return correlation;
}

void Correlation::Apply(std::vector<double>& uniforms) const {
  DOCKYARD_CHECK(uniforms.size() == keys_);
  // From the last key to the first, so that those before it are still the independent ones.
  for (const Row& row : rows_) {
    double z = 0.0;
    for (const Term& term : row.terms) z += term.weight * NormalQuantile(uniforms[term.key]);
    uniforms[row.key] = std::clamp(NormalShare(z), kEnd, 1.0 - kEnd);
  }
}

}  // namespace dockyard
