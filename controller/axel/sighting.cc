#include "controller/axel/sighting.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {
namespace {

// Two sightings from one place differ by noise only. Three sigma of 0.2 m at 5 m and 4.6 deg (Tsai
// et al., V-E).
bool Agree(const BoardFix& a, const BoardFix& b) {
  return std::abs(a.range_m - b.range_m) < 0.05 + 0.1 * a.range_m &&
         std::abs(WrapPi(a.bearing_rad - b.bearing_rad)) < 0.05 &&
         std::abs(WrapPi(a.heading_rad - b.heading_rad)) < 0.2;
}

// A pipeline without a covariance: the filter's noise of the board's heading.
double AttitudeSigma(const DockSighting& sighting) {
  const Eigen::Matrix3d turn = sighting.covariance.bottomRightCorner<3, 3>();
  if (turn.trace() > 0.0) return std::sqrt(turn.trace());
  const FilterNoise noise;
  return noise.board_heading_floor_rad + noise.board_heading_rad_per_m * sighting.X_RB.p.norm();
}

}  // namespace

void RuleOut(const std::string& why, Belief* belief) {
  belief->last_sighting->accepted = false;
  belief->last_sighting->reason = why;
}

LocateHints HintsFrom(const Senses& senses) {
  LocateHints hints;
  hints.up_R = UpOfStation(senses.attitude(), !senses.ground().level());
  hints.X_RB_expected = senses.ExpectedBoard();
  return hints;
}

void CameraTurnFilter::Take(const DockSighting& sighting) {
  if (!sighting.stereo || !sighting.camera_turn.mean_rad.allFinite()) return;
  // The mount moves with temperature: assumed 0.01 deg from sighting to sighting (0-0.03).
  constexpr double kDrift = 0.01 * kPi / 180.0;
  // The lens's own errors act as a turn that differs from place to place and does not average out
  // as noise does. So the belief stays at least this wide (assumed 0.02 deg, 0.01-0.05).
  constexpr double kFloor = 0.02 * kPi / 180.0;
  belief_ = sighting.camera_turn;
  belief_.covariance.diagonal().array() += kDrift * kDrift;
  for (int i = 0; i < 3; ++i) {
    belief_.covariance(i, i) = std::max(belief_.covariance(i, i), kFloor * kFloor);
  }
}

std::optional<BoardFix> SightingJudge::FixOf(const DockSighting& sighting, const Senses& senses,
                                             GroundSlope* ground) const {
  const bool finite = sighting.X_RB.p.allFinite() && sighting.X_RB.R.allFinite();
  if (finite) ground->Take(sighting.X_RB, AttitudeSigma(sighting), senses.imu(), X_DB_);
  BoardFix fix = LevelSighting(sighting.X_RB, senses.imu(), X_DB_, *ground);
  fix.variance = FixVariance(sighting.X_RB.p, sighting.covariance);
  const bool in_front = std::abs(fix.bearing_rad) < 0.5 * kPi;
  if (!finite || !in_front || fix.range_m < options_.min_range_m ||
      fix.range_m > options_.max_range_m) {
    return std::nullopt;
  }
  return fix;
}

void SightingJudge::Accept(const BoardFix& fix, const GroundSlope& ground, Senses* senses) {
  senses->filter().Correct(fix);
  senses->SetGround(ground);
  doubted_.reset();
  doubts_ = 0;
  why_ = "board seen";
}

SightingJudge::Ruling SightingJudge::Judge(const DockSighting& sighting, Senses* senses) {
  GroundSlope ground = senses->ground();
  const std::optional<BoardFix> fix = FixOf(sighting, *senses, &ground);
  if (!fix) {
    why_ = "board where it cannot be seen";
    return Ruling::kRejected;
  }
  if (!senses->filter().Fits(*fix)) return Doubt(*fix, senses);
  Accept(*fix, ground, senses);
  return Ruling::kAccepted;
}

bool SightingJudge::JudgeUnderWay(const DockSighting& sighting, Senses* senses) {
  GroundSlope ground = senses->ground();
  const std::optional<BoardFix> fix = FixOf(sighting, *senses, &ground);
  if (!fix || !senses->filter().Fits(*fix)) return false;
  Accept(*fix, ground, senses);
  return true;
}

SightingJudge::Ruling SightingJudge::Doubt(const BoardFix& fix, Senses* senses) {
  doubts_ = doubted_ && Agree(*doubted_, fix) ? doubts_ + 1 : 1;
  ++doubts_here_;
  doubted_ = fix;
  if (doubts_ >= options_.contradictions) {
    senses->filter().Restart(fix);
    doubted_.reset();
    doubts_ = 0;
    why_ = "dead reckoning dropped";
    return Ruling::kAccepted;
  }
  why_ = "sighting contradicts dead reckoning";
  return doubts_here_ < options_.contradictions ? Ruling::kLookAgain : Ruling::kRejected;
}

}  // namespace dockyard::axel
