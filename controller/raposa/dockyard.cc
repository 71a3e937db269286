#include "controller/raposa/dockyard.h"

#include "controller/raposa/pilot.h"
#include "controller/raposa/pyramid_eye.h"

namespace dockyard::raposa {
namespace {

class Dockyard final : public Controller {
 public:
  explicit Dockyard(const Nominal& nominal)
      : delay_s_(nominal.camera_delay_s), eye_(nominal), pilot_(nominal, {}) {}

  Commands Step(const SensorFrame& sensed) override {
    const RgbImage* image = RgbImageOf(sensed, kBackCamera);
    if (image == nullptr) return pilot_.Step(sensed, nullptr, 0.0);
    const PyramidSeen seen = eye_.Find(*image, pilot_.pitch_rad(), pilot_.Prior());
    Tick exposed = sensed.tick;
    for (const CameraImage& taken : sensed.images) {
      if (taken.camera == kBackCamera) exposed = taken.exposed;
    }
    const double since_s = static_cast<double>(sensed.tick - exposed) * kTickSeconds;
    return pilot_.Step(sensed, &seen, since_s + delay_s_);
  }
  const Belief& belief() const override { return pilot_.belief(); }

 private:
  double delay_s_;
  PyramidEye eye_;
  Pilot pilot_;
};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  return std::make_unique<Dockyard>(nominal);
}

}  // namespace dockyard::raposa
