#include "controller/vision/board/noise_raise.h"

#include <algorithm>
#include <cmath>

#include "controller/base/median.h"
#include "controller/vision/board/pose_gates.h"

namespace dockyard {
namespace {

// Independent errors of a smooth shape: the terms of a surface of second degree. Assumed, 4-12.
constexpr double kSmoothTerms = 6.0;

double Worst(const Fix& fix) {
  return *std::max_element(fix.fit.mark_sigmas.begin(), fix.fit.mark_sigmas.end());
}

/// The factor on the sigmas at which the median error is as expected, at least 1.
double MedianScale(const Fix& fix, double scale) {
  const std::vector<double>& sigmas = fix.fit.mark_sigmas;
  // Chi-square's median with two degrees of freedom, less the part that the pose takes.
  const double share = std::max(0.25, 1.0 - 3.0 / static_cast<double>(sigmas.size()));
  return std::max(1.0, scale * Median(sigmas) / std::sqrt(2.0 * std::log(2.0) * share));
}

/// The factor at which the sum of squares is as expected, at least 1.
double RmsScale(const Fix& fix, double scale) {
  return std::max(1.0, scale * std::sqrt(fix.fit.misfit / std::max(1, fix.fit.freedom)));
}

/// Fits at the factor that `next` gives until it stays. The less the marks are believed, the less
/// of their errors goes into the calibration's terms, so the factor changes with the fit.
template <class Next>
Fix Settled(FitInputs& inputs, Fix at, Next next) {
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    const double before = inputs.refine.noise_scale, scale = next(at, before);
    if (std::abs(scale - before) < 0.01 * before) break;
    inputs.refine.noise_scale = scale;
    at = Refit(inputs, at, at.marks, true);
  }
  return at;
}

bool EachFitsAlone(const FitInputs& inputs, const Fix& fix) {
  constexpr double kBetterAlone = 3.0, kAgree_px = 0.5;  // assumed, 2-6 and 0.3-1
  constexpr std::size_t kLeast = 5;
  if (fix.method != "stereo" || fix.fit.rms_px < kAgree_px) return false;
  for (int view = 0; view < 2; ++view) {
    std::vector<MarkPixel> mine;
    for (const MarkPixel& mark : fix.marks) {
      if (mark.view == view) mine.push_back(mark);
    }
    if (mine.size() < kLeast) return false;
    Fix alone = fix;
    alone.method = view == 0 ? "left" : "right";
    if (kBetterAlone * Refit(inputs, alone, mine).fit.rms_px > fix.fit.rms_px) return false;
  }
  return true;
}

/// The marks' variance over what it would be for a flat board and an exact calibration, on average.
double VarianceOverPredicted(const FitInputs& inputs, const Fix& fix) {
  double sum = 0.0;
  for (const MarkPixel& mark : fix.marks) {
    const CameraView& view = inputs.views[static_cast<std::size_t>(mark.view)];
    const auto sigma_px = [&](const RefineOptions& options) {
      return MarkSigmaPx(mark, view, inputs.board, fix.fit.X_RB, options);
    };
    const double ratio = sigma_px(inputs.refine) / sigma_px(RefineOptions{});
    sum += ratio * ratio;
  }
  return sum / static_cast<double>(fix.marks.size());
}

/// The covariances when what exceeds the prediction comes from a few smooth shapes.
void WidenForSmoothErrors(FitInputs inputs, Fix* fix) {
  const double variance = VarianceOverPredicted(inputs, *fix);
  const double alike = static_cast<double>(fix->marks.size()) / kSmoothTerms - 1.0;
  if (!(variance > 1.0) || !(alike > 0.0)) return;
  inputs.refine.noise_scale *= std::sqrt(1.0 + (1.0 - 1.0 / variance) * alike);
  const Fix shown = Refit(inputs, *fix, fix->marks, true);
  fix->fit.covariance = shown.fit.covariance;
  fix->fit.turn.covariance = shown.fit.turn.covariance;
}

}  // namespace

double MostRaisedRmsPx(int freedom) {
  constexpr double kMost_px = 1.0;
  constexpr double kGate_px = 2.5;   // correspond.cc, GatePx
  constexpr double kFive_px = 0.12;  // of five marks that err by 0.06 px, at ChiSquareLimit
  constexpr double kFreedomOfFive = 4.0;
  if (freedom < kFreedomOfFive) return 0.0;
  return std::min(kMost_px, kGate_px * std::pow(kFive_px / kGate_px, kFreedomOfFive / freedom));
}

RaisedFix WithNoiseRaised(FitInputs inputs, const Fix& fix) {
  // The prediction explains the median: marks far above it are wrong, not the prediction.
  constexpr double kAsPredicted = 1.5;
  const FitInputs predicted = inputs;
  Fix at = Settled(inputs, Refit(inputs, fix, fix.marks, true), MedianScale);
  bool fits = false;
  if (inputs.refine.noise_scale < kAsPredicted) {
    const Fix judged = WithoutStrays(predicted, fix);
    fits = judged.fit.misfit <= ChiSquareLimit(judged.fit.freedom);
    if (fits) {
      inputs.refine = predicted.refine;
      at = judged;
    }
  }
  if (!fits) at = WithoutStrays(inputs, at);
  const bool contradict = !fits && Worst(at) >= kStraySigmas;
  at = Settled(inputs, at, RmsScale);
  RaisedFix raised{.fix = at};
  const bool far = !fits && at.fit.rms_px > MostRaisedRmsPx(at.fit.freedom);
  if (contradict || far || EachFitsAlone(inputs, at)) {
    raised.failure = at.method == "stereo" ? PoseFailure::kCamerasDisagree : PoseFailure::kPoorFit;
  }
  WidenForSmoothErrors(inputs, &raised.fix);
  return raised;
}

}  // namespace dockyard
