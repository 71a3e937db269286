#include "controller/rocky7/stone_memory.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Stones of 3-5 cm that a user may click on: how far they stand out. Assumed, 10-30 mm.
constexpr double kHeight_m = 0.02, kHeightSigma_m = 0.006;
constexpr double kWildSize = 8.0;  // the most that counts, in squares of sigmas; assumed, 4-12
// Chance that the stone that was clicked on is not told from the ground at first. Assumed,
// 0.02-0.2.
constexpr double kHidden = 0.05;
// The range data where the user clicked may be of the ground beside the stone, or wrong: against it
// counts no more than this. Its variance over that of the click on the ground and the stone's.
// Assumed, 2-5 and 0.2-1.
constexpr double kWildRange = 4.0, kRangeShare = 0.3;
// A stone further from the click than so many sigmas is another one. Assumed, 2.5-4.
constexpr double kOnRay = 3.5;
// Another stone is taken for the one that was clicked on from these log odds on. Assumed, 0.5-2.
constexpr double kKeeps = 1.0;
constexpr double kDoubtful = 0.3;  // chance that it is a stone; assumed, 0.1-0.5
// Of the ground's height between here and there. Assumed, 3-10 mm.
constexpr double kUneven_m = 0.005;
// A remembered stone is not known better than this: looks have errors in common. Assumed, 1-4 mm.
constexpr double kBest_m = 0.002;
// So many stones are remembered, while the chance that they are stones is no less. Assumed, 6-20
// and 0.02-0.1.
constexpr std::size_t kMostStones = 13;
constexpr double kForgotten = 0.05;
// A height this many sigmas off teaches nothing. Assumed, 2-3.
constexpr double kWildHeight = 2.5;
constexpr double kSurely = 0.8;  // chance that it is a stone; assumed, 0.6-0.95
// A target that two image pairs in a row do not show is a part of a stone whose middle is this
// near: a stone of 5 cm by half. Assumed, 2-4 and 3-5 cm.
constexpr int kNotAgain = 2;
constexpr double kOneStone_m = 0.035;

// Middles of two stones are no nearer to each other: one of 3 cm and one of 2 cm that touch.
// Assumed, 2.2-3 cm.
constexpr double kTwin_m = 0.025;
// The highest chance of a stone: at 1 it could never fade, and images may be wrong in the same
// manner again. Assumed, 0.99-0.9999.
constexpr double kMostReal = 0.999;

}  // namespace

Matrix2d ClickRay::SpreadAt(double height_m) const {
  const double down_m = up_m - height_m, r = down_m * along.norm();
  const Vector2d ahead = along.normalized();
  const double a = sigma_rad * (r * r + down_m * down_m) / down_m + kUneven_m * along.norm();
  const double b = sigma_rad * std::hypot(r, down_m);
  return spread_m2 + a * a * ahead * ahead.transpose() +
         b * b * (Matrix2d::Identity() - ahead * ahead.transpose());
}

// How well a stone is where the user clicked, and is of a size to be clicked on.
double StoneMemory::Likelihood(const FieldStone& stone) const {
  const double middle_m = 0.5 * stone.height_m;
  const Vector2d off = stone.p - click_.At(middle_m);
  const Matrix2d spread = click_.SpreadAt(middle_m) + stone.spread_m2;
  const double sigma_m = std::hypot(kHeightSigma_m, stone.height_sigma_m);
  const double height = (stone.height_m - kHeight_m) / sigma_m;
  const double sigma2_m2 = click_.SpreadAt(middle_m).trace() + stone.spread_m2.trace();
  const double range = (stone.p - click_.range_data).squaredNorm() / (kRangeShare * sigma2_m2);
  return std::log(stone.real) - 0.5 * off.dot(spread.inverse() * off) -
         0.5 * std::min(range, kWildRange) - 0.5 * std::log(spread.determinant()) -
         0.5 * std::min(height * height, kWildSize);
}

bool StoneMemory::IsOnRay(const FieldStone& stone) const {
  const double middle_m = 0.5 * stone.height_m;
  const Vector2d off = stone.p - click_.At(middle_m);
  const Matrix2d spread = click_.SpreadAt(middle_m) + stone.spread_m2;
  return off.dot(spread.inverse() * off) < kOnRay * kOnRay;
}

// The first keeps its place where the odds are small, as long as it is seen.
void StoneMemory::Choose() {
  if (settled_) return TakeWhole();
  std::size_t best = 0;
  const FieldStone& target = stones_.front();
  double most = Likelihood(target) + (target.real > kDoubtful ? kKeeps : 0.0);
  for (std::size_t i = 1; i < stones_.size(); ++i) {
    const double now = Likelihood(stones_[i]);
    if (now <= most || !IsOnRay(stones_[i])) continue;
    most = now;
    best = i;
  }
  std::swap(stones_.front(), stones_[best]);
}

void StoneMemory::TakeWhole() {
  if (missed_ < kNotAgain) return;
  std::size_t nearest = 0;
  double least_m = kOneStone_m;
  for (std::size_t i = 1; i < stones_.size(); ++i) {
    const double away_m = (stones_[i].p - target().p).norm();
    if (away_m > least_m || stones_[i].real < kSurely) continue;
    least_m = away_m;
    nearest = i;
  }
  if (nearest == 0) return;
  std::swap(stones_.front(), stones_[nearest]);
  stones_.erase(stones_.begin() + static_cast<std::ptrdiff_t>(nearest));
  missed_ = 0;
}

bool StoneMemory::Begin(const ClickRay& click, double ground_m,
                        const std::vector<FieldStone>& seen) {
  click_ = click;
  stones_ = seen;
  if (stones_.size() > kMostStones) stones_.resize(kMostStones);
  // The one that may not be told from the ground from here.
  const Vector2d p = click_.At(0.5 * kHeight_m);
  stones_.insert(stones_.begin(), {.p = p,
                                   .spread_m2 = click_.SpreadAt(0.5 * kHeight_m),
                                   .height_m = kHeight_m,
                                   .height_sigma_m = kHeightSigma_m,
                                   .ground_m = ground_m,
                                   .real = kHidden});
  Choose();
  return target().real != kHidden || target().p != p;
}

bool StoneMemory::HasSeenTargetWell() const { return target().real > kSurely; }

bool StoneMemory::IsNeighbour(const Vector2d& from_target_m) const {
  const Vector2d p = target().p + from_target_m;
  return std::any_of(stones_.begin() + 1, stones_.end(), [&](const FieldStone& other) {
    return other.real > kDoubtful && (other.p - p).norm() < from_target_m.norm();
  });
}

void StoneMemory::Loosen(double by_m) {
  stones_.front().spread_m2 += by_m * by_m * Matrix2d::Identity();
}

void StoneMemory::Learn(const std::vector<FieldStone>& seen, const FieldMatch& match,
                        const FieldSettings& with) {
  std::vector<bool> known(seen.size(), false);
  missed_ = match.seen.front() < 0 ? missed_ + 1 : 0;
  Shift(match.shift_m);
  click_.spread_m2 += match.spread_m2;
  for (std::size_t i = 0; i < match.seen.size(); ++i) {
    FieldStone& stone = stones_[i];
    if (match.seen[i] < 0) {
      const double hidden = 1.0 - with.seen_again;
      stone.real *= hidden / (hidden * stone.real + 1.0 - stone.real);
      stone.spread_m2 += match.spread_m2;
      continue;
    }
    const auto j = static_cast<std::size_t>(match.seen[i]);
    known[j] = true;
    const Matrix2d gain = stone.spread_m2 * (stone.spread_m2 + seen[j].spread_m2).inverse();
    stone.p += gain * (seen[j].p - stone.p);
    stone.spread_m2 =
        (Matrix2d::Identity() - gain) * stone.spread_m2 + kBest_m * kBest_m * Matrix2d::Identity();
    stone.ground_m = seen[j].ground_m;
    stone.real = std::min(kMostReal, 1.0 - (1.0 - stone.real) * (1.0 - seen[j].real));
    const double was = stone.height_sigma_m, is = seen[j].height_sigma_m;
    const double off = seen[j].height_m - stone.height_m;
    if (std::abs(off) > kWildHeight * std::hypot(was, is)) continue;
    stone.height_m += was * was / (was * was + is * is) * off;
    stone.height_sigma_m = std::max(kBest_m, was * is / std::hypot(was, is));
  }
  MergeTwins(match.seen);
  // A new one in an old one's place is that one, seen worse before. Of the target the click tells.
  for (std::size_t j = 0; j < seen.size(); ++j) {
    if (known[j]) continue;
    const auto old = std::find_if(stones_.begin() + 1, stones_.end(), [&](const FieldStone& stone) {
      return (stone.p - seen[j].p).norm() < with.one_stone_m;
    });
    if (old == stones_.end()) {
      stones_.push_back(seen[j]);
    } else if (old->real < seen[j].real) {
      *old = seen[j];
    }
  }
  // The target stays, whatever is seen of it.
  std::stable_sort(stones_.begin() + 1, stones_.end(),
                   [](const FieldStone& a, const FieldStone& b) { return a.real > b.real; });
  while (stones_.size() > kMostStones || (stones_.size() > 1 && stones_.back().real < kForgotten)) {
    stones_.pop_back();
  }
}

void StoneMemory::MergeTwins(std::vector<int> shown) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    for (std::size_t j = i + 1; j < shown.size();) {
      const bool twins =
          (shown[i] < 0) != (shown[j] < 0) && (stones_[i].p - stones_[j].p).norm() < kTwin_m;
      if (!twins) {
        ++j;
        continue;
      }
      if (shown[i] < 0) stones_[i] = stones_[j];
      shown[i] = std::max(shown[i], shown[j]);
      shown.erase(shown.begin() + static_cast<std::ptrdiff_t>(j));
      stones_.erase(stones_.begin() + static_cast<std::ptrdiff_t>(j));
      if (i == 0) missed_ = 0;
    }
  }
}

void StoneMemory::Turn(const Pose2& X_ET) {
  const Matrix2d turn = Eigen::Rotation2Dd(X_ET.heading).toRotationMatrix();
  for (FieldStone& stone : stones_) {
    stone.p = X_ET * stone.p;
    stone.spread_m2 = (turn * stone.spread_m2 * turn.transpose()).eval();
  }
  click_.from = X_ET * click_.from;
  click_.range_data = X_ET * click_.range_data;
  click_.along = (turn * click_.along).eval();
  click_.spread_m2 = (turn * click_.spread_m2 * turn.transpose()).eval();
}

void StoneMemory::Shift(const Vector2d& by_m) {
  for (FieldStone& stone : stones_) stone.p += by_m;
  click_.from += by_m;
  click_.range_data += by_m;
}

}  // namespace dockyard::rocky7
