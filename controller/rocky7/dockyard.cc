#include "controller/rocky7/dockyard.h"

#include "controller/rocky7/mission.h"
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
  TargetSeen Begin(const ElevationMap& map, const Eigen::Vector2d& p_E_clicked) override {
    const StoneMiddle stone = FindStone(map, p_E_clicked, settings_);
    if (stone.verdict == StoneVerdict::kFound || stone.verdict == StoneVerdict::kSeveral) {
      return Keep(map, stone);
    }
    const auto height = Bilinear(map, p_E_clicked);
    return {.found = true,
            .p_E = p_E_clicked,
            .height_m = height ? height->height_m : 0.0,
            .why = WhyNot(stone.verdict)};
  }

  TargetSeen Follow(const ElevationMap& map, const Pose2& X_ET_predicted) override {
    StoneMiddle stone = FindStone(map, {X_ET_predicted.x, X_ET_predicted.y}, settings_);
    if (stone.verdict == StoneVerdict::kSeveral) {
      const TrackedShape shape = FindShape(shape_, map, X_ET_predicted, shapes_);
      if (shape.verdict != TrackVerdict::kFound) return {.why = WhyNot(stone.verdict)};
      StoneMiddleSettings narrow = settings_;
      narrow.apart_m = 0.0;
      stone = FindStone(map, {shape.X_ET.x, shape.X_ET.y}, narrow);
    }
    if (stone.verdict != StoneVerdict::kFound) {
      return {.gone = stone.verdict == StoneVerdict::kFlat, .why = WhyNot(stone.verdict)};
    }
    if (height_m_ > 0.0 &&
        std::abs(stone.height_m - height_m_) > kOtherHeight_m + kOtherShare * height_m_) {
      return {.why = "another stone stands where the target should be"};
    }
    return Keep(map, stone);
  }

  // Scoops leave heaps and trenches, but none as high as the stone was.
  TargetSeen Check(const ElevationMap& map, const Pose2& X_ET) override {
    StoneMiddleSettings near = settings_;
    near.apart_m = 0.0;
    const StoneMiddle stone = FindStone(map, {X_ET.x, X_ET.y}, near);
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
  TargetSeen Keep(const ElevationMap& map, const StoneMiddle& stone) {
    shape_ = ShapeAbout(map, {stone.p_E.x(), stone.p_E.y(), 0.0}, shapes_);
    height_m_ = stone.height_m;
    const double ground_m = stone.ground.dot(Eigen::Vector3d(1.0, stone.p_E.x(), stone.p_E.y()));
    return {.found = true, .p_E = stone.p_E, .height_m = ground_m + stone.height_m};
  }

  // Heights of one stone from look to look: tops are up to 2.5 mm low at 1 m, with 2.2 mm of sigma.
  // Assumed, 5-15 mm and 0.2-0.6.
  static constexpr double kOtherHeight_m = 0.008, kOtherShare = 0.4;
  // Heaps before this share of the stone's height; assumed, 0.4-0.8.
  static constexpr double kHeapShare = 0.6;

  StoneMiddleSettings settings_;
  WholeShapeSettings shapes_;
  HeightPatch shape_;
  double height_m_ = 0.0;
};

// Larger steps than the paper's: the stone is looked for within 6 cm of where odometry has it.
// Assumed, 0.15-0.4.
constexpr ApproachOptions kOptions{.image_share = 0.3,
                                   .least_step_m = 0.06,
                                   .claim_share = 0.6,  // assumed, 0.4-0.8: what is seen errs too
                                   .backs_up = true,
                                   .most_looks = 60,
                                   .blind_beyond_m = 0.25,  // assumed, 0.2-0.5
                                   .most_misses = 4};

// Assumed, 1-5 tries.
constexpr MissionOptions kMission{.tries = 3, .peeks = true};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  return std::make_unique<Mission>(nominal, std::make_unique<StoneTracker>(), kOptions, kMission);
}

}  // namespace dockyard::rocky7
