#include "controller/rocky7/dockyard.h"

#include "controller/rocky7/approach.h"
#include "controller/tracking/whole_shape.h"

namespace dockyard::rocky7 {
namespace {

std::string WhyNot(TrackVerdict verdict) {
  switch (verdict) {
    case TrackVerdict::kFound:
      break;
    case TrackVerdict::kFlat:
      return "the ground about the target has no shape";
    case TrackVerdict::kUnseen:
      return "too little of the ground about the target is seen";
    case TrackVerdict::kMisfit:
      return "the ground there has another shape";
    case TrackVerdict::kAmbiguous:
      return "two places have that shape";
  }
  return "";
}

class WholeShape final : public TargetTracker {
 public:
  TargetSeen Begin(const ElevationMap& map, const Eigen::Vector2d& p_E_clicked) override {
    const Pose2 X_ET{p_E_clicked.x(), p_E_clicked.y(), 0.0};
    shape_ = ShapeAbout(map, X_ET, settings_);
    if (shape_.Relief() < settings_.least_relief_m) return {.why = WhyNot(TrackVerdict::kFlat)};
    const auto height = Bilinear(map, p_E_clicked);
    return {.found = true, .p_E = p_E_clicked, .height_m = height ? height->height_m : 0.0};
  }

  TargetSeen Follow(const ElevationMap& map, const Pose2& X_ET_predicted) override {
    const TrackedShape at = FindShape(shape_, map, X_ET_predicted, settings_);
    if (at.verdict != TrackVerdict::kFound) return {.why = WhyNot(at.verdict)};
    // Nearer by, more of the shape is seen, and sharper.
    shape_ = ShapeAbout(map, {at.X_ET.x, at.X_ET.y, 0.0}, settings_);
    return {.found = true, .p_E = {at.X_ET.x, at.X_ET.y}, .height_m = at.height_m};
  }

 private:
  WholeShapeSettings settings_;
  HeightPatch shape_;
};

// Larger steps than the paper's where the target is far, as the whole shape is found again within
// 8 cm. Assumed, 0.15-0.4.
constexpr ApproachOptions kOptions{.image_share = 0.3,
                                   .least_step_m = 0.06,
                                   .claim_share = 0.6,  // assumed, 0.4-0.8: what is seen errs too
                                   .backs_up = true,
                                   .most_looks = 60,
                                   .most_misses = 3};

class Dockyard final : public Controller {
 public:
  explicit Dockyard(const Nominal& nominal)
      : approach_(nominal, std::make_unique<WholeShape>(), kOptions) {}

  Commands Step(const SensorFrame& sensed) override { return approach_.Step(sensed); }
  const Belief& belief() const override { return approach_.belief(); }

 private:
  Approach approach_;
};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  return std::make_unique<Dockyard>(nominal);
}

}  // namespace dockyard::rocky7
