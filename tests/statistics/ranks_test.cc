#include "sim/statistics/ranks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/base/random.h"
#include "statistics/correlations_of_columns.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Column = std::vector<double>;

Column Normals(RandomStream& random, int n) {
  Column values;
  for (int i = 0; i < n; ++i) values.push_back(random.Normal());
  return values;
}

/// Spearman's correlation of two normal values with the correlation r (Pearson 1907).
double RankCorrelationOfNormals(double r) { return 6.0 / std::numbers::pi * std::asin(0.5 * r); }

TEST(Ranks, AreSharedByEqualValues) {
  EXPECT_THAT(Ranks({10.0, 20.0, 20.0, 5.0}), ElementsAre(2.0, 3.5, 3.5, 1.0));
  EXPECT_THAT(Ranks({7.0, 7.0, 7.0}), ElementsAre(2.0, 2.0, 2.0));
  EXPECT_TRUE(Ranks({}).empty());
}

TEST(Ranks, AreNotThereWithAValueThatIsNot) {
  for (const double rank : Ranks({1.0, kNaN, 2.0})) EXPECT_TRUE(std::isnan(rank));
}

TEST(Ranks, PutInfinitiesAtTheEnds) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THAT(Ranks({inf, 0.0, -inf}), ElementsAre(3.0, 2.0, 1.0));
}

TEST(Spearman, HasItsClosedFormForEveryOrderOfSix) {  // 1 - 6 sum d^2 / (n (n^2 - 1))
  const Column x{1, 2, 3, 4, 5, 6};
  Column y = x;
  do {
    double squares = 0.0;
    for (std::size_t i = 0; i < 6; ++i) squares += (x[i] - y[i]) * (x[i] - y[i]);
    EXPECT_NEAR(Spearman(x, y).value, 1.0 - 6.0 * squares / 210.0, 1e-14);
  } while (std::next_permutation(y.begin(), y.end()));
}

// By hand: ranks 1.5 1.5 3 4 and 1 3 3 3, deviations -1 -1 .5 1.5 and -1.5 .5 .5 .5:
// 2 / sqrt(4.5 * 3).
TEST(Spearman, SharesTheRanksOfEqualValues) {
  EXPECT_NEAR(Spearman({2, 2, 5, 9}, {0, 1, 1, 1}).value, 2.0 / std::sqrt(13.5), 1e-15);
}

// R package statpsych, example of ci.spear, which takes Bonett and Wright's variance as well.
TEST(Spearman, GivesThePublishedInterval) {
  const Column y{21, 4, 9, 12, 35, 18, 10, 22, 24, 1, 6, 8, 13, 16, 19};
  const Column x{67, 28, 30, 28, 52, 40, 25, 37, 44, 10, 14, 20, 28, 40, 51};
  const Estimate r = Spearman(x, y);
  EXPECT_NEAR(r.value, 0.8699639, 5e-8);
  EXPECT_NEAR(r.interval.low, 0.5840951, 5e-8);
  EXPECT_NEAR(r.interval.high, 0.9638297, 5e-8);
}

TEST(Spearman, IsOneOfAnyRisingRelation) {
  Column x, rising, falling;
  for (int i = 0; i < 50; ++i) {
    x.push_back(0.1 * i);
    rising.push_back(std::exp(x.back()));
    falling.push_back(-std::pow(x.back(), 3.0));
  }
  EXPECT_NEAR(Spearman(x, rising).value, 1.0, 1e-15);
  EXPECT_NEAR(Spearman(x, falling).value, -1.0, 1e-15);
  EXPECT_NEAR(Spearman(x, rising).interval.low, 1.0, 1e-14);  // no width: as documented
}

TEST(Spearman, CoversWithItsConfidence) {
  RandomStream random(StreamKey(7, "spearman"));
  for (const double r : {0.0, 0.5, 0.9}) {
    int covered = 0;
    constexpr int kSamples = 2000;
    for (int sample = 0; sample < kSamples; ++sample) {
      const Column x = Normals(random, 40), noise = Normals(random, 40);
      Column y;
      for (std::size_t i = 0; i < 40; ++i) y.push_back(r * x[i] + std::sqrt(1 - r * r) * noise[i]);
      const Interval interval = Spearman(x, y).interval;
      const double truth = RankCorrelationOfNormals(r);
      covered += interval.low <= truth && truth <= interval.high;
    }
    EXPECT_NEAR(double(covered) / kSamples, 0.95, 0.02) << r;  // four standard deviations
  }
}

void ExpectUnknown(const Estimate& estimate) {
  EXPECT_TRUE(std::isnan(estimate.value));
  EXPECT_TRUE(std::isnan(estimate.interval.low));
  EXPECT_TRUE(std::isnan(estimate.interval.high));
}

TEST(Spearman, IsUnknownWhereItCannotBeTold) {
  ExpectUnknown(Spearman({}, {}));
  ExpectUnknown(Spearman({1, 2}, {3, 4}));
  ExpectUnknown(Spearman({1, 1, 1, 1}, {1, 2, 3, 4}));
  ExpectUnknown(Spearman({1, 2, 3, 4}, {1, kNaN, 3, 4}));
  const Estimate three = Spearman({1, 2, 3}, {1, 3, 2});
  EXPECT_NEAR(three.value, 0.5, 1e-15);
  EXPECT_TRUE(std::isnan(three.interval.low));
}

TEST(PartialRankCorrelations, OfOneInputAreSpearmans) {
  const Column x{3, 1, 4, 1, 5, 9, 2, 6}, y{2, 7, 1, 8, 2, 8, 1, 8};
  const Estimate partial = PartialRankCorrelations({x}, y)[0], whole = Spearman(x, y);
  EXPECT_NEAR(partial.value, whole.value, 1e-14);
  EXPECT_NEAR(partial.interval.low, whole.interval.low, 1e-14);
}

// By hand: sums of d^2 are 2 (x1, y), 20 (x2, y) and 30 (x1, x2), so the rank correlations are 0.9,
// 0 and -0.5, and r_1y.2 = (0.9 - 0 (-0.5)) / sqrt((1 - 0)(1 - 0.25)), r_2y.1 = (0 - 0.9 (-0.5)) /
// sqrt((1 - 0.81)(1 - 0.25)) by the formula of three variables.
TEST(PartialRankCorrelations, OfTwoInputsFollowTheFormulaOfThreeVariables) {
  const Column x1{1, 2, 3, 4, 5}, y{2, 1, 3, 4, 5}, x2{2, 5, 4, 1, 3};
  EXPECT_NEAR(Spearman(x1, y).value, 0.9, 1e-15);
  const double r2y = Spearman(x2, y).value, r12 = Spearman(x1, x2).value;
  const std::vector<Estimate> r = PartialRankCorrelations({x1, x2}, y);
  EXPECT_NEAR(r[0].value, (0.9 - r2y * r12) / std::sqrt((1 - r2y * r2y) * (1 - r12 * r12)), 1e-14);
  EXPECT_NEAR(r[1].value, (r2y - 0.9 * r12) / std::sqrt((1 - 0.81) * (1 - r12 * r12)), 1e-14);
}

/// Inputs without correlation, and the sum of these times their weights.
struct Sums {
  std::vector<Column> inputs;
  Column output;
};

Sums DrawSums(RandomStream& random, const std::vector<double>& weights, int n) {
  Sums sums;
  sums.output.assign(static_cast<std::size_t>(n), 0.0);
  for (const double weight : weights) {
    sums.inputs.push_back(Normals(random, n));
    for (std::size_t i = 0; i < sums.output.size(); ++i) {
      sums.output[i] += weight * sums.inputs.back()[i];
    }
  }
  return sums;
}

/// Of the first input of such a sum, to which noise of that weight is added, from the population's
/// rank correlations: s1 / sqrt(1 - s2^2 - s3^2 ...).
double PartialOfSums(const std::vector<double>& weights, double noise) {
  double length = noise * noise, rest = 1.0;
  for (const double weight : weights) length += weight * weight;
  for (std::size_t i = 1; i < weights.size(); ++i) {
    const double s = RankCorrelationOfNormals(weights[i] / std::sqrt(length));
    rest -= s * s;
  }
  return RankCorrelationOfNormals(weights[0] / std::sqrt(length)) / std::sqrt(rest);
}

TEST(PartialRankCorrelations, OfAWeightedSumAreItsWeights) {
  RandomStream random(StreamKey(8, "prcc"));
  const Sums sums = DrawSums(random, {1.0, -2.0, 0.0, 0.5}, 20'000);
  const std::vector<Estimate> r = PartialRankCorrelations(sums.inputs, sums.output);
  EXPECT_NEAR(r[0].value, PartialOfSums({1.0, -2.0, 0.5}, 0.0), 0.01);
  EXPECT_NEAR(r[1].value, PartialOfSums({-2.0, 1.0, 0.5}, 0.0), 0.01);
  EXPECT_NEAR(r[2].value, 0.0, 0.03);
  EXPECT_NEAR(r[3].value, PartialOfSums({0.5, 1.0, -2.0}, 0.0), 0.01);
}

TEST(PartialRankCorrelations, SeeThroughAnInputThatOnlyGoesWithTheCause) {
  RandomStream random(StreamKey(9, "prcc"));
  const Column cause = Normals(random, 5000), blur = Normals(random, 5000);
  const Column noise = Normals(random, 5000);
  Column companion, output;
  for (std::size_t i = 0; i < cause.size(); ++i) {
    companion.push_back(cause[i] + 0.5 * blur[i]);
    output.push_back(std::exp(cause[i] + noise[i]));
  }
  EXPECT_GT(Spearman(companion, output).value, 0.5);
  EXPECT_NEAR(PartialRankCorrelations({cause, companion}, output)[1].value, 0.0, 0.06);
}

TEST(PartialRankCorrelations, CoverWithTheirConfidence) {
  RandomStream random(StreamKey(10, "prcc"));
  const double truth = PartialOfSums({0.6, 0.3, 0.3}, 0.7);
  int covered = 0;
  constexpr int kSamples = 2000;
  for (int sample = 0; sample < kSamples; ++sample) {
    Sums sums = DrawSums(random, {0.6, 0.3, 0.3, 0.7}, 25);
    sums.inputs.pop_back();  // the last is noise
    const Interval interval = PartialRankCorrelations(sums.inputs, sums.output)[0].interval;
    covered += interval.low <= truth && truth <= interval.high;
  }
  EXPECT_NEAR(double(covered) / kSamples, 0.95, 0.02);
}

TEST(PartialRankCorrelations, SpendOneRunOnEachOtherInput) {
  RandomStream random(StreamKey(11, "prcc"));
  const Sums sums = DrawSums(random, {1.0, 1.0, 1.0}, 20);
  const Estimate r = PartialRankCorrelations(sums.inputs, sums.output)[0];
  const double half = 1.959963984540054 * std::sqrt((1.0 + 0.5 * r.value * r.value) / (20 - 2 - 3));
  EXPECT_NEAR(r.interval.low, std::tanh(std::atanh(r.value) - half), 1e-12);
  EXPECT_NEAR(r.interval.high, std::tanh(std::atanh(r.value) + half), 1e-12);
}

TEST(PartialRankCorrelations, LeaveOutAnInputThatDoesNotVary) {
  RandomStream random(StreamKey(12, "prcc"));
  const Sums sums = DrawSums(random, {1.0, 0.5, 1.0}, 30);
  const std::vector<Column> varied{sums.inputs[0], sums.inputs[1]};
  const std::vector<Column> with_constant{sums.inputs[0], Column(30, 4.0), sums.inputs[1]};
  const auto expected = PartialRankCorrelations(varied, sums.output);
  const auto found = PartialRankCorrelations(with_constant, sums.output);
  EXPECT_EQ(found[0].value, expected[0].value);
  EXPECT_EQ(found[0].interval.low, expected[0].interval.low);
  ExpectUnknown(found[1]);
  EXPECT_EQ(found[2].value, expected[1].value);
}

TEST(PartialRankCorrelations, CannotTellInputsOfOneOrderApart) {
  RandomStream random(StreamKey(13, "prcc"));
  const Sums sums = DrawSums(random, {1.0, 0.5, 1.0}, 30);
  Column copy;
  for (const double x : sums.inputs[0]) copy.push_back(x * x * x);
  const auto found = PartialRankCorrelations({sums.inputs[0], copy, sums.inputs[1]}, sums.output);
  ExpectUnknown(found[0]);
  ExpectUnknown(found[1]);
  const auto expected = PartialRankCorrelations({sums.inputs[0], sums.inputs[1]}, sums.output)[1];
  EXPECT_NEAR(found[2].value, expected.value, 1e-12);
  EXPECT_NEAR(found[2].interval.low, expected.interval.low, 1e-12);
}

TEST(PartialRankCorrelations, AreUnknownWhereTheyCannotBeTold) {
  EXPECT_TRUE(PartialRankCorrelations({}, {1, 2, 3}).empty());
  ExpectUnknown(PartialRankCorrelations({{}}, {})[0]);
  const Column x{1, 2, 3, 4, 5, 6}, z{3, 1, 2, 6, 5, 4};
  ExpectUnknown(PartialRankCorrelations({x, z}, Column(6, 1.0))[0]);
  ExpectUnknown(PartialRankCorrelations({x, {1, 2, kNaN, 4, 5, 6}}, z)[0]);
  ExpectUnknown(PartialRankCorrelations({x}, {1, 2, kNaN, 4, 5, 6})[0]);
  // x explains the output: nothing is left for z.
  const auto explained = PartialRankCorrelations({x, z}, {2, 4, 8, 16, 32, 64});
  EXPECT_NEAR(explained[0].value, 1.0, 1e-12);
  ExpectUnknown(explained[1]);
  // As many inputs as runs.
  for (const Estimate& r : PartialRankCorrelations({{1, 2, 3}, {2, 1, 3}, {1, 3, 2}}, {3, 1, 2})) {
    ExpectUnknown(r);
  }
}

RankCorrelations Correlated(const std::vector<Column>& inputs, const std::vector<Column>& outputs) {
  RankTable table(outputs[0].size(), inputs.size() + outputs.size());
  for (const Column& output : outputs) table.AddOutput(Ranks(output));
  for (const Column& input : inputs) table.AddInput(Ranks(input));
  return table.Correlate();
}

TEST(RankTable, OfManyOutputsAreThoseOfEach) {
  RandomStream random(StreamKey(14, "prcc"));
  const Sums sums = DrawSums(random, {1.0, -0.5, 0.2}, 5000);  // more rows than a block has
  const Column noise = Normals(random, 5000);
  Column share, unknown = noise;
  for (std::size_t i = 0; i < noise.size(); ++i) share.push_back(sums.output[i] > noise[i]);
  unknown[7] = kNaN;
  const auto all = Correlated(sums.inputs, {sums.output, share, unknown, Column(5000, 1.0), noise});
  const std::vector<const Column*> known{&sums.output, &share, nullptr, nullptr, &noise};
  for (std::size_t o = 0; o < known.size(); ++o) {
    for (std::size_t i = 0; i < sums.inputs.size(); ++i) {
      if (known[o] == nullptr) {
        ExpectUnknown(all.spearman[o][i]);
        ExpectUnknown(all.partial[o][i]);
        continue;
      }
      const Estimate whole = Spearman(sums.inputs[i], *known[o]);
      EXPECT_NEAR(all.spearman[o][i].value, whole.value, 1e-12);
      EXPECT_NEAR(all.spearman[o][i].interval.low, whole.interval.low, 1e-12);
      const Estimate partial = PartialRankCorrelations(sums.inputs, *known[o])[i];
      EXPECT_NEAR(all.partial[o][i].value, partial.value, 1e-12);
    }
  }
}

TEST(RankTable, OfAHundredThousandRunsLoseNoDigit) {
  RandomStream random(StreamKey(15, "prcc"));
  const Sums sums = DrawSums(random, {1.0, -2.0}, 100'000);
  const auto found = Correlated(sums.inputs, {sums.output});
  EXPECT_NEAR(found.spearman[0][0].value, RankCorrelationOfNormals(1.0 / std::sqrt(5.0)), 0.012);
  const Column x = Ranks(sums.inputs[1]), y = Ranks(sums.output);
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += (x[i] - y[i]) * (x[i] - y[i]);
  EXPECT_NEAR(found.spearman[0][1].value, 1.0 - 6.0 * squares / (1e5 * (1e10 - 1.0)), 1e-12);
}

}  // namespace
}  // namespace dockyard
