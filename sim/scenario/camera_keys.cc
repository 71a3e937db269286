#include "sim/scenario/camera_keys.h"

namespace dockyard {
namespace {

void VisitEye(Keys& keys, EyeFaults& eye) {
  keys.Choice({"picture", "", "what the camera gives; a dark one has no light on its sensor"},
              eye.picture, {"normal", "dark", "none"});
  keys.Number({"cover", "", "share of the picture behind an opaque cover on the window"},
              eye.cover_share, NonNegative(0.95));
  keys.Degrees({"cover_side_deg", "deg", "the cover's side: 0 right, 90 up, 180 left, -90 down"},
               eye.cover_side_rad, Between(-180.0, 180.0));
  keys.Number({"dust", "", "share of the picture behind clumps of dust on the window"},
              eye.dust_share, NonNegative(0.8));
  keys.Number({"dust_clump_m", "m", "the clumps' median diameter"}, eye.dust_clump_m,
              Between(1e-5, 2e-3));
  keys.Number({"dust_scatter", "", "share of the light on the clumps that veils the picture"},
              eye.dust_scatter, NonNegative(1.0));
}

// Sources of the ranges: docs/reference/images.md.
void VisitStray(Keys& keys, StrayModel& stray) {
  keys.Number({"veil", "", "share of the light that every lens scatters over the image"},
              stray.veil, NonNegative(0.2));
  keys.Degrees({"core_deg", "deg", "width of the scattered light's bright core"}, stray.core_rad,
               Between(0.1, 4.0));
  keys.Number({"ghosts", "", "share of the sun's light that comes as ghosts, discs of reflections"},
              stray.ghosts, NonNegative(0.01));
}

void VisitFaults(Keys& keys, CameraFaults& faults) {
  keys.Number({"delay_s", "s", "from a picture's exposure to its arrival"}, faults.delay_s,
              NonNegative(10.0));
  keys.Number({"lost", "", "probability that the pictures asked for are lost"}, faults.lost,
              NonNegative(1.0));
  keys.Number(
      {"clock_offset_s", "s", "by which the images' stamps are ahead of the controller's clock"},
      faults.clock_offset_s, Between(-0.5, 0.5));
  keys.Number({"clock_drift_ppm", "ppm", "by which that grows, of the time since power-on"},
              faults.clock_drift_ppm, Between(-1000.0, 1000.0));
  keys.Number({"pupil_m", "m", "diameter of the lens's pupil, for what lies on the window"},
              faults.pupil_m, Between(1e-4, 5e-3));
  keys.Number({"window_m", "m", "from the pupil to the window with cover and dust"},
              faults.window_m, Between(5e-3, 0.2));
  keys.Mapping({"left", "", ""}, [&](Keys& in) { VisitEye(in, faults.left); });
  keys.Mapping({"right", "", ""}, [&](Keys& in) { VisitEye(in, faults.right); });
}

}  // namespace

void VisitCamera(Keys& keys, Scenario& s) {
  using enum Presence;
  keys.File({"file", "", "cameras instead of the robot's own", kUnset}, s.camera_file);
  keys.Integer({"width_px", "px", "image width, given together with height_px", kUnset},
               s.image_width, 64, 4096);
  keys.Integer({"height_px", "px", "image height, given together with width_px", kUnset},
               s.image_height, 64, 4096);
  keys.Bool({"colour", "", "`view` writes colour images beside the grey ones"}, s.colour);
  keys.Mapping({"stray", "", ""}, [&](Keys& in) { VisitStray(in, s.sun.stray); });
  VisitFaults(keys, s.camera_faults);
}

}  // namespace dockyard
