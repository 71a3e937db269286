#include "controller/raposa/dockyard.h"

#include "controller/raposa/pilot.h"
#include "controller/raposa/pyramid_finder.h"

namespace dockyard::raposa {
namespace {

class Dockyard final : public Controller {
 public:
  explicit Dockyard(const Nominal& nominal)
      : delay_s_(nominal.camera_delay_s), finder_(nominal), pilot_(nominal, {}) {}

  Commands Step(const SensorFrame& sensed) override {
    const RgbImage* image = RgbImageOf(sensed, kBackCamera);
    if (image == nullptr) return pilot_.Step(sensed, nullptr, 0.0);
    const ImageHints hints = pilot_.Hints();
    const PyramidSighting sighting =
        finder_.Find(*image, hints.pitch_rad, hints.prior, hints.refuted);
    Tick exposed = sensed.tick;
    for (const CameraImage& taken : sensed.images) {
      if (taken.camera == kBackCamera) exposed = taken.exposed;
    }
    const double since_s = static_cast<double>(sensed.tick - exposed) * kTickSeconds;
    return pilot_.Step(sensed, &sighting, since_s + delay_s_);
  }
  const Belief& belief() const override { return pilot_.belief(); }

 private:
  double delay_s_;
  PyramidFinder finder_;
  Pilot pilot_;
};

}  // namespace

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal) {
  return std::make_unique<Dockyard>(nominal);
}

}  // namespace dockyard::raposa
