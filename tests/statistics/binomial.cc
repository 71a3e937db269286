#include "statistics/binomial.h"

#include <cmath>

namespace dockyard {

double BinomialChance(int k, int n, double p) {
  return std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) +
                  k * std::log(p) + (n - k) * std::log1p(-p));
}

double BinomialAtMost(int k, int n, double p) {
  double sum = 0.0;
  for (int i = 0; i <= k; ++i) sum += BinomialChance(i, n, p);
  return sum;
}

double BinomialAtLeast(int k, int n, double p) {
  double sum = 0.0;
  for (int i = k; i <= n; ++i) sum += BinomialChance(i, n, p);
  return sum;
}

}  // namespace dockyard
