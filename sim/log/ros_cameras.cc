#include "sim/log/ros_cameras.h"

#include <Eigen/Geometry>
#include <optional>

#include "sim/log/ros_messages.h"

namespace dockyard {
namespace {

/// A lens as ROS has it: its name, coefficients, focal lengths and centre.
struct RosLens {
  const char* model = "";
  std::vector<double> d;
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
};

RosLens LensOf(const Camera& camera) {
  if (const auto* fish = std::get_if<KannalaBrandt>(&camera.lens)) {
    return {"equidistant", {fish->k.begin(), fish->k.end()}, fish->fx, fish->fy, fish->cx,
            fish->cy};
  }
  if (const auto* brown = std::get_if<BrownPinhole>(&camera.lens)) {
    return {"plumb_bob", {brown->k1, brown->k2, brown->p1, brown->p2, brown->k3},
            brown->fx,   brown->fy,
            brown->cx,   brown->cy};
  }
  if (const auto* rational = std::get_if<RationalPinhole>(&camera.lens)) {
    const auto& k = rational->k;
    return {"rational_polynomial", {k[0], k[1], rational->p1, rational->p2, k[2], k[3], k[4], k[5]},
            rational->fx,          rational->fy,
            rational->cx,          rational->cy};
  }
  const Eigen::Vector2d focal = camera.focal_px(), centre = camera.centre_px();
  return {"", {}, focal.x(), focal.y(), centre.x(), centre.y()};
}

/// The place of the right camera of the pair that this one is the left of.
std::optional<std::size_t> RightOf(const std::vector<NamedCamera>& cameras, std::size_t left) {
  constexpr std::string_view kLeft = "left";
  std::string name = cameras[left].name;
  if (!name.ends_with(kLeft)) return std::nullopt;
  name.replace(name.size() - kLeft.size(), kLeft.size(), "right");
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (cameras[i].name == name && cameras[i].body == cameras[left].body) return i;
  }
  return std::nullopt;
}

Eigen::Matrix<double, 3, 4> Projection(const RosLens& lens) {
  Eigen::Matrix<double, 3, 4> P;
  P << lens.fx, 0.0, lens.cx, 0.0, 0.0, lens.fy, lens.cy, 0.0, 0.0, 0.0, 1.0, 0.0;
  return P;
}

/// The turn from the body's axes to those of the rectified images: x along the baseline, z as near
/// to both views as that allows.
Eigen::Matrix3d RectifiedAxes(const NamedCamera& left, const NamedCamera& right) {
  const Eigen::Vector3d x = (right.X_OC.p - left.X_OC.p).normalized();
  const Eigen::Vector3d views = left.X_OC.R.col(2) + right.X_OC.R.col(2);
  const Eigen::Vector3d z = (views - views.dot(x) * x).normalized();
  Eigen::Matrix3d R;
  R << x.transpose(), z.cross(x).transpose(), z.transpose();
  return R;
}

/// Identity where rounding alone keeps it from that.
Eigen::Matrix3d Cleaned(const Eigen::Matrix3d& R) {
  constexpr double kRounding = 1e-9;
  return R.isIdentity(kRounding) ? Eigen::Matrix3d::Identity() : R;
}

}  // namespace

std::vector<RosRectification> RectificationsOf(const std::vector<NamedCamera>& cameras) {
  std::vector<RosRectification> all(cameras.size());
  for (std::size_t i = 0; i < cameras.size(); ++i) all[i].P = Projection(LensOf(cameras[i].camera));
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const std::optional<std::size_t> other = RightOf(cameras, i);
    if (!other) continue;
    const NamedCamera &left = cameras[i], &right = cameras[*other];
    const double baseline_m = (right.X_OC.p - left.X_OC.p).norm();
    if (baseline_m == 0.0) continue;
    const Eigen::Matrix3d R = RectifiedAxes(left, right);
    all[i].R = Cleaned(R * left.X_OC.R);
    all[*other].R = Cleaned(R * right.X_OC.R);
    all[*other].P = all[i].P;
    all[*other].P(0, 3) = -all[i].P(0, 0) * baseline_m;
  }
  return all;
}

std::string CameraInfoMessage(Tick tick, const std::string& frame, const Camera& camera,
                              const RosRectification& rectification) {
  const RosLens lens = LensOf(camera);
  CdrWriter out;
  PutHeader(out, tick, frame);
  out.U32(static_cast<std::uint32_t>(camera.height));
  out.U32(static_cast<std::uint32_t>(camera.width));
  out.Text(lens.model);
  out.Doubles(lens.d);
  for (const double k : {lens.fx, 0.0, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0}) {
    out.Double(k);
  }
  const auto put = [&](const auto& matrix) {
    for (int row = 0; row < matrix.rows(); ++row) {
      for (int column = 0; column < matrix.cols(); ++column) out.Double(matrix(row, column));
    }
  };
  put(rectification.R);
  put(rectification.P);
  for (int i = 0; i < 6; ++i) out.U32(0);  // no binning, the whole image
  out.Bool(false);
  return out.Take();
}

}  // namespace dockyard
