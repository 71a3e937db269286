// The paper's tracker on the mast's pictures: only tops of rocks were its targets (Nesnas, Maimone
// and Das, V).
#include "controller/rocky7/face_tracker.h"
#include "controller/tracking/local_maximum.h"

namespace dockyard::rocky7 {
namespace {

// Of the map about the window. Assumed, 0.15-0.4 m.
constexpr double kTopMap_m = 0.2;

class TopTracker final : public FaceTracker {
 public:
  explicit TopTracker(const NesnasTracking& with) : settings_{with.window_m} {}

  FaceSighting Begin(const FaceStereo& stereo, const FaceView& view,
                     const Eigen::Vector2d& pixel) override {
    const auto p_C = PointUnder(view.pair, view.disparities, pixel);
    if (!p_C) return {.why = "no range data where the user clicked"};
    return Find(stereo, view, view.pair.X_RC * *p_C);
  }
  FaceSighting Follow(const FaceStereo& stereo, const FaceView& view,
                      const FaceExpected& target) override {
    return Find(stereo, view, target.p_E);
  }

 private:
  FaceSighting Find(const FaceStereo& stereo, const FaceView& view,
                    const Eigen::Vector3d& p_E) const {
    const auto top = HighestInWindow(stereo.HeightsAbout(view, p_E.head<2>(), kTopMap_m),
                                     p_E.head<2>(), settings_);
    if (!top) return {.why = "no range data in the window"};
    FaceSighting seen{.found = true, .p_E = {top->p_E.x(), top->p_E.y(), top->height_m}};
    const Eigen::Vector3d p_C = Inverse(view.pair.X_RC) * seen.p_E;
    seen.range_m = p_C.norm();
    if (p_C.z() <= 0.0) return seen;
    const Eigen::Vector2d pixel =
        view.pair.centre_px + view.pair.focal_px * p_C.head<2>() / p_C.z();
    if (const auto plane = stereo.PlaneAt(view, pixel)) {
      seen.normal_E = plane->normal;
      seen.normal_sigma_rad = plane->normal_sigma_rad;
    }
    return seen;
  }

  LocalMaximumSettings settings_;
};

}  // namespace

std::unique_ptr<FaceTracker> MakeTopTracker(const NesnasTracking& with) {
  return std::make_unique<TopTracker>(with);
}

}  // namespace dockyard::rocky7
