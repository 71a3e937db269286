// Binomial chances term by term: independent of the incomplete beta function.
#pragma once

namespace dockyard {

/// P(X = k) of n trials with a chance p in (0, 1) each. Good to about 1e-12 for n up to 1000.
double BinomialChance(int k, int n, double p);
/// P(X <= k)
double BinomialAtMost(int k, int n, double p);
/// P(X >= k)
double BinomialAtLeast(int k, int n, double p);

}  // namespace dockyard
