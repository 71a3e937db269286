#include "models/read/read_stereo.h"

#include "models/parts/mounting.h"
#include "models/read/load_cameras.h"
#include "models/read/load_mounting.h"
#include "models/read/visit_sensor.h"

namespace dockyard {
namespace {

/// Cameras side by side, facing along the body's x axis, pitched down together.
StereoRig MakeRig(double baseline_m, double forward_m, double height_m, double pitch_rad,
                  const Camera& camera) {
  Eigen::Matrix3d R_level;  // z along the view, x right, y down
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d R = RotY(pitch_rad) * R_level;
  StereoRig rig;
  rig.left = rig.right = camera;
  rig.X_RL = {R, Eigen::Vector3d(forward_m, 0.5 * baseline_m, height_m)};
  rig.X_RQ = {R, Eigen::Vector3d(forward_m, -0.5 * baseline_m, height_m)};
  return rig;
}

void VisitAsBuilt(Keys& keys, StereoModel& stereo) {
  keys.Degrees("relative_yaw_deg", stereo.relative_yaw_sigma_rad, NonNegative(5.0));
  keys.Degrees("rotation_deg", stereo.rotation_sigma_rad, NonNegative(5.0));
  VisitLensErrors(keys, stereo.lens, Presence::kRequired);
}

}  // namespace

StereoRig MountedRig(const StereoRig& rig, const StereoModel& stereo) {
  const Eigen::Vector3d p_R_middle = 0.5 * (rig.X_RL.p + rig.X_RQ.p);
  StereoRig mounted = rig;
  mounted.X_RL = Mounted(rig.X_RL, stereo.mounting, p_R_middle);
  mounted.X_RQ =
      Mounted(Mounted(rig.X_RQ, stereo.right_mounting, rig.X_RQ.p), stereo.mounting, p_R_middle);
  return mounted;
}

void VisitStereo(Keys& keys, const char* key, StereoFile& file) {
  StereoModel& stereo = file.stereo;
  keys.Mapping(key, [&](Keys& in) {
    VisitMounting(in, stereo.mounting);
    VisitMounting(in, stereo.right_mounting, "right_mounting");
    in.File(Unset("file"), file.rig);
    const bool own = file.rig.empty();
    for (const char* of_rig : {"baseline_m", "forward_m", "height_m", "pitch_deg",
                               "field_of_view_deg", "width_px", "height_px"}) {
      in.Allow(of_rig, own, "no such key beside " + std::string(key) + ".file, which sets it");
    }
    in.Degrees(in.NeededIf(own, "field_of_view_deg"), file.field_of_view_rad, Between(10.0, 200.0));
    in.Number(in.NeededIf(own, "baseline_m"), file.baseline_m, Between(0.01, 2.0));
    in.Number(in.NeededIf(own, "forward_m"), file.forward_m, Between(-2.0, 2.0));
    in.Number(in.NeededIf(own, "height_m"), file.height_m, Between(-2.0, 3.0));
    in.Degrees(Optional("pitch_deg"), file.pitch_rad, Between(-60.0, 60.0));
    in.Integer(Optional("width_px"), file.size.width, 64, 4096);
    in.Integer(in.NeededIf(file.size.width > 0, "height_px"), file.size.height, 64, 4096);
    in.Mapping("as_built", [&](Keys& inner) { VisitAsBuilt(inner, stereo); });
    in.Mapping("sensor",
               [&](Keys& inner) { VisitSensor(inner, stereo.sensor, Presence::kRequired); });
  });
}

StereoModel StereoOf(const StereoFile& file, const PixelSize& size, const PixelSize& usual) {
  StereoModel stereo = file.stereo;
  const PixelSize own = size.width > 0 ? size : file.size.width > 0 ? file.size : usual;
  const StereoRig rig =
      !file.rig.empty() ? LoadRig(file.rig, size.width, size.height)
                        : MakeRig(file.baseline_m, file.forward_m, file.height_m, file.pitch_rad,
                                  EquidistantCamera(own.width, own.height, file.field_of_view_rad));
  stereo.nominal = MountedRig(rig, stereo);
  return stereo;
}

}  // namespace dockyard
