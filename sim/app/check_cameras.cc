#include "sim/app/check_cameras.h"

#include <cmath>
#include <cstdio>

#include "models/read/calibrations.h"
#include "models/read/load_cameras.h"
#include "sim/base/count_text.h"

namespace dockyard {
namespace {

std::string PixelsText(const Camera& camera) {
  return std::to_string(camera.width) + " x " + std::to_string(camera.height) + " px";
}

void WarnOfRayless(const std::string& name, const Camera& camera, FileCheck& check) {
  const RaylessPixels rayless = CountRayless(camera);
  if (!rayless.at) return;
  const double all = static_cast<double>(camera.width) * camera.height;
  char text[200];
  std::snprintf(text, sizeof text,
                "%.2f %% of the pixels have no ray (%ld of %.0f; none at %g %g): they are masked, "
                "and the renderer cannot draw this camera",
                100.0 * static_cast<double>(rayless.count) / all, rayless.count, all,
                rayless.at->x(), rayless.at->y());
  check.warnings.push_back((name.empty() ? "" : name + ": ") + text);
}

/// The side of the right camera, by the greatest part of its place: x right, y down, z ahead.
const char* SideOf(const Eigen::Vector3d& p_LQ) {
  Eigen::Index axis = 0;
  p_LQ.cwiseAbs().maxCoeff(&axis);
  const char* sides[3][2] = {
      {"to the left", "to the right"}, {"above", "below"}, {"behind", "ahead"}};
  return sides[axis][p_LQ[axis] > 0.0 ? 1 : 0];
}

/// Warnings about the right camera's place.
void WarnOfPlace(const StereoRig& rig, const Eigen::Vector3d& p_LQ, FileCheck& check) {
  constexpr double kLongBaseline_m = 10.0;  // assumed; 5-50: no robot carries a longer one
  const std::string side = SideOf(p_LQ);
  if (side != "to the right") {
    char text[300];
    std::snprintf(text, sizeof text,
                  "the right camera is %s%s the left one, at (%.4g, %.4g, %.4g) m right, down "
                  "and ahead of it: is the sign of T turned round, T's inverse meant, or left and "
                  "right exchanged?",
                  side.c_str(),
                  side == "to the left" ? " of"
                  : side == "ahead"     ? " of"
                                        : "",
                  p_LQ.x(), p_LQ.y(), p_LQ.z());
    check.warnings.emplace_back(text);
  }
  if (rig.baseline_m() > kLongBaseline_m) {
    check.warnings.push_back("the cameras are " + NumberText(rig.baseline_m()) +
                             " m apart: is T given in millimetres?");
  }
}

FileCheck CheckFirst(const std::string& kind, const std::vector<PlacedCamera>& cameras) {
  const Camera& first = cameras[0].camera;
  FileCheck check{kind, CountText(cameras.size(), "camera, ", "cameras, the first of ") +
                            PixelsText(first) + ", " +
                            NumberText(std::round(10.0 * first.focal_px().x()) / 10.0) + " px/rad"};
  for (const PlacedCamera& placed : cameras) WarnOfRayless(placed.name, placed.camera, check);
  return check;
}

}  // namespace

bool IsCalibration(const YamlNode& root) { return FormOf(root) != CalibrationForm::kOurs; }

FileCheck CheckCameras(const std::string& file) {
  if (IsCalibration(LoadCameraTree(file))) return CheckCalibration(file);
  return CheckFirst("camera", LoadCameras(file));
}

FileCheck CheckRig(const std::string& file) {
  const StereoRig rig = LoadRig(file, 0, 0, Rays::kMasked);
  const Eigen::Vector3d p_LQ = Inverse(rig.X_RL) * rig.X_RQ.p;
  FileCheck check{"rig", PixelsText(rig.left) + ", baseline " +
                             NumberText(std::round(1e4 * rig.baseline_m()) / 1e4) +
                             " m, right camera " + SideOf(p_LQ)};
  WarnOfRayless("left", rig.left, check);
  WarnOfRayless("right", rig.right, check);
  WarnOfPlace(rig, p_LQ, check);
  return check;
}

FileCheck CheckCalibration(const std::string& file) {
  const std::vector<PlacedCamera> cameras = LoadCameras(file);
  FileCheck check = cameras.size() == 2 ? CheckRig(file) : CheckFirst("camera", cameras);
  check.summary = std::string(NameOf(FormOf(LoadCameraTree(file)))) + ": " + check.summary;
  return check;
}

}  // namespace dockyard
