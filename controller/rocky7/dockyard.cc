#include "controller/rocky7/dockyard.h"

#include <algorithm>
#include <cmath>

#include "controller/rocky7/mission.h"
#include "controller/rocky7/place_mission.h"
#include "controller/tracking/local_maximum.h"
#include "controller/tracking/stone_middle.h"
#include "controller/tracking/whole_shape.h"

namespace dockyard::rocky7 {
namespace {

std::string WhyNot(StoneVerdict verdict) {
  switch (verdict) {
    case StoneVerdict::kFound:
      break;
    case StoneVerdict::kFlat:
      return "nothing stands out where the target should be";
    case StoneVerdict::kBorder:
      return "what stands out is cut by the window";
    case StoneVerdict::kUnseen:
      return "too little of the ground about the target is seen";
    case StoneVerdict::kSeveral:
      return "two stones are as near to where the target should be";
  }
  return "";
}

// The middle of the stone that was clicked on. Where a second stone is as near to the prediction,
// the whole shape about the target tells which is which.
class StoneTracker final : public TargetTracker {
 public:
  // A click is nearer to its stone than to another one. From afar a stone may be too low to be told
  // from the ground; then the place that was clicked on is the target until it is seen.
  TargetSeen Begin(const GroundMaps& maps, const Eigen::Vector2d& p_E_clicked) override {
    const StoneMiddle stone = FindStone(maps.fine, p_E_clicked, settings_);
    if (stone.verdict == StoneVerdict::kFound || stone.verdict == StoneVerdict::kSeveral) {
      return Keep(maps, stone);
    }
    const auto height = Bilinear(maps.closed, p_E_clicked);
    return {.found = true,
            .p_E = p_E_clicked,
            .height_m = height ? height->height_m : 0.0,
            .sigma_m = kClick_m,
            .why = WhyNot(stone.verdict)};
  }

  TargetSeen Follow(const GroundMaps& maps, const Predicted& target) override {
    StoneMiddleSettings settings = settings_;
    settings.window_m = std::clamp(3.0 * target.sigma_m, kLeastWindow_m, kMostWindow_m);
    StoneMiddle stone = FindStone(maps.fine, {target.X_ET.x, target.X_ET.y}, settings);
    if (stone.verdict == StoneVerdict::kSeveral) {
      const TrackedShape shape = FindShape(shape_, maps.closed, target.X_ET, shapes_);
      if (shape.verdict != TrackVerdict::kFound) return Guess(maps, target, stone.verdict);
      StoneMiddleSettings narrow = settings;
      narrow.apart_m = 0.0;
      stone = FindStone(maps.fine, {shape.X_ET.x, shape.X_ET.y}, narrow);
    }
    if (stone.verdict != StoneVerdict::kFound) return Guess(maps, target, stone.verdict);
    if (height_m_ > 0.0 &&
        std::abs(stone.height_m - height_m_) > kOtherHeight_m + kOtherShare * height_m_) {
      return {.why = "another stone stands where the target should be"};
    }
    return Keep(maps, stone);
  }

  // Scoops leave heaps and trenches, but none as high as the stone was.
  TargetSeen Check(const GroundMaps& maps, const Pose2& X_ET) override {
    StoneMiddleSettings near = settings_;
    near.apart_m = 0.0;
    const StoneMiddle stone = FindStone(maps.fine, {X_ET.x, X_ET.y}, near);
    const bool stands =
        stone.verdict == StoneVerdict::kFound && stone.height_m > kHeapShare * height_m_;
    const bool seen = stone.verdict != StoneVerdict::kUnseen;
    return {.found = stands,
            .gone = seen && !stands,
            .p_E = stands ? stone.p_E : Eigen::Vector2d(X_ET.x, X_ET.y),
            .height_m = stone.height_m,
            .why = stands ? "the stone still stands there" : "no stone stands there any more"};
  }

 private:
  // The paper's: what is highest there. It cannot tell that the target is gone.
  static TargetSeen Guess(const GroundMaps& maps, const Predicted& target, StoneVerdict verdict) {
    TargetSeen seen{.gone = verdict == StoneVerdict::kFlat, .why = WhyNot(verdict)};
    const auto top =
        HighestInWindow(maps.fine, {target.X_ET.x, target.X_ET.y}, LocalMaximumSettings{});
    if (!top) return seen;
    seen.guess = true;
    seen.p_E = top->p_E;
    seen.sigma_m = kClick_m;
    return seen;
  }

  TargetSeen Keep(const GroundMaps& maps, const StoneMiddle& stone) {
    shape_ = ShapeAbout(maps.closed, {stone.p_E.x(), stone.p_E.y(), 0.0}, shapes_);
    height_m_ = stone.height_m;
    const double ground_m = stone.ground.dot(Eigen::Vector3d(1.0, stone.p_E.x(), stone.p_E.y()));
    return {.found = true, .p_E = stone.p_E, .height_m = ground_m + stone.height_m};
  }

  // Heights of one stone from look to look: tops are up to 2.5 mm low at 1 m, with 2.2 mm of sigma.
  // Assumed, 5-15 mm and 0.2-0.6.
  static constexpr double kOtherHeight_m = 0.008, kOtherShare = 0.4;
  // Of the window in which the target is looked for. Assumed, 3-5 and 8-15 cm.
  static constexpr double kLeastWindow_m = 0.04, kMostWindow_m = 0.12;
  // Of a click on what is not told from the ground: two pixels at 1.3 m. Assumed, 2-5 cm.
  static constexpr double kClick_m = 0.03;
  // Heaps before this share of the stone's height; assumed, 0.4-0.8.
  static constexpr double kHeapShare = 0.6;

  StoneMiddleSettings settings_;
  WholeShapeSettings shapes_;
  HeightPatch shape_;
  double height_m_ = 0.0;
};

// Larger steps than the paper's, as the window follows from them. Assumed, 0.15-0.4.
constexpr ApproachOptions kOptions{.image_share = 0.25,
                                   .least_step_m = 0.06,
                                   .claim_share = 0.6,  // assumed, 0.4-0.8: what is seen errs too
                                   .turn_by_unit = true,
                                   .slip = 0.1,  // assumed, 0.05-0.2
                                   .exposes_for_target = true,
                                   .backs_up = true,
                                   .most_looks = 60,
                                   .blind_beyond_m = 0.25,  // assumed, 0.2-0.5
                                   .most_misses = 4};

// Assumed, 1-5 tries.
constexpr MissionOptions kMission{.tries = 3, .peeks = true};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  if (nominal.task == Task::kPlace) return MakeDockyardPlacement(nominal);
  return std::make_unique<Mission>(nominal, std::make_unique<StoneTracker>(), kOptions, kMission);
}

}  // namespace dockyard::rocky7
