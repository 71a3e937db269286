#include "sim/vehicles/wheel_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace dockyard {
namespace {

const double kGauss = 1.0 / std::sqrt(3.0);
// A face's contact this near to the tip or to the rim gives way to theirs [m]; assumed, 2-8 mm.
constexpr double kNearEnd_m = 4e-3;
// Features of one face of a paddle: two on its edge, two between tip and rim.
constexpr int kFaceFeatures = 4;

// One face of a paddle, in the body's frame.
struct Face {
  Eigen::Vector3d foot, out, left, normal;  // foot: on the rim, amid the width; unit vectors
  double height_m = 0.0, half_width_m = 0.0;

  Eigen::Vector3d At(double left_m, double out_m) const {
    return foot + left_m * left + out_m * out;
  }
};

// The width that the body covers of a face between rim and tip; false: none.
bool Covers(const ConvexBody& body, const Face& face, double& low_m, double& high_m) {
  low_m = face.half_width_m;
  high_m = -face.half_width_m;
  const auto Take = [&](const Eigen::Vector2d& p) {
    low_m = std::min(low_m, std::clamp(p.x(), -face.half_width_m, face.half_width_m));
    high_m = std::max(high_m, std::clamp(p.x(), -face.half_width_m, face.half_width_m));
  };
  for (const auto& t : body.triangles) {
    Eigen::Vector2d ends[3];
    int count = 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d a = body.vertices[t[i]] - face.foot;
      const Eigen::Vector3d b = body.vertices[t[(i + 1) % 3]] - face.foot;
      const double at_a = face.normal.dot(a), at_b = face.normal.dot(b);
      if ((at_a < 0.0) == (at_b < 0.0)) continue;
      const Eigen::Vector3d p = a + (at_a / (at_a - at_b)) * (b - a);
      ends[count++] = {face.left.dot(p), face.out.dot(p)};
    }
    if (count < 2) continue;
    // The piece of the section's outline between rim and tip.
    const Eigen::Vector2d way = ends[1] - ends[0];
    double from = 0.0, to = 1.0;
    const auto Cut = [&](double start, double change) {  // keeps start + share * change >= 0
      if (change > 0.0) from = std::max(from, -start / change);
      if (change < 0.0) to = std::min(to, -start / change);
      if (change == 0.0 && start < 0.0) from = 2.0;
    };
    Cut(ends[0].y(), way.y());
    Cut(face.height_m - ends[0].y(), -way.y());
    Cut(ends[0].x() + face.half_width_m, way.x());
    Cut(face.half_width_m - ends[0].x(), -way.x());
    if (from > to) continue;
    Take(ends[0] + from * way);
    Take(ends[0] + to * way);
  }
  return low_m < high_m;
}

void AddFace(const ConvexBody& body, const Face& face, int feature,
             std::vector<BodyContact>& contacts) {
  const double w = face.half_width_m, h = face.height_m;
  AddEdgeContacts(body, face.At(-w, h), face.At(w, h), feature, contacts);
  double low_m = 0.0, high_m = 0.0;
  if (!Covers(body, face, low_m, high_m)) return;
  const double middle_m = 0.5 * (low_m + high_m), gauss_m = 0.5 * kGauss * (high_m - low_m);
  for (int i = 0; i < 2; ++i) {
    const double at_m = i == 0 ? middle_m - gauss_m : middle_m + gauss_m;
    const Eigen::Vector3d a = face.At(at_m, 0.0), b = face.At(at_m, h);
    const std::optional<PressedEdge> pressed = PressEdge(body, a, b);
    if (!pressed || pressed->depth_m <= 0.0) continue;
    const double end_m = h * std::min(pressed->deepest, 1.0 - pressed->deepest);
    const double share = 0.5 * std::min(1.0, end_m / kNearEnd_m);
    if (share <= 0.0) continue;
    contacts.push_back({feature + 2 + i, a + pressed->deepest * (b - a), pressed->normal,
                        pressed->depth_m, share});
  }
}

// Whether the body's sphere is off the box round a paddle.
bool IsApart(const ConvexBody& body, const Face& face, double thickness_m) {
  const Eigen::Vector3d r = body.centre - face.foot;
  const double out_m = face.out.dot(r);
  const double off_out = out_m - std::clamp(out_m, 0.0, face.height_m);
  const double off_left = std::max(0.0, std::abs(face.left.dot(r)) - face.half_width_m);
  const double off_along = std::max(0.0, std::abs(face.normal.dot(r)) - 0.5 * thickness_m);
  return off_out * off_out + off_left * off_left + off_along * off_along >
         body.radius_m * body.radius_m;
}

}  // namespace

void AddWheelContacts(const ConvexBody& body, const WheelModel& wheel, const Pose3& X_AK,
                      std::vector<BodyContact>& contacts) {
  const double half_width_m = 0.5 * wheel.width_m;
  const double reach_m = body.radius_m + std::hypot(RollingRadius(wheel), half_width_m);
  if ((X_AK.p - body.centre).squaredNorm() > reach_m * reach_m) return;
  const Eigen::Vector3d left = X_AK.R.col(1);
  AddCylinderContacts(body, {X_AK.p, left, wheel.rim_radius_m, half_width_m}, 0, contacts);
  for (int i = 0; i < wheel.paddle_count; ++i) {
    const double angle = wheel.phase_rad + 2.0 * kPi * i / wheel.paddle_count;
    Face face;
    face.out = X_AK.R * Eigen::Vector3d(std::cos(angle), 0.0, -std::sin(angle));
    face.left = left;
    face.normal = face.out.cross(left);
    face.foot = X_AK.p + wheel.rim_radius_m * face.out;
    face.height_m = wheel.paddle_height_m;
    face.half_width_m = half_width_m;
    if (IsApart(body, face, wheel.paddle_thickness_m)) continue;
    for (int side = 0; side < 2; ++side) {
      Face one = face;
      one.foot += (side - 0.5) * wheel.paddle_thickness_m * face.normal;
      AddFace(body, one, 2 + kFaceFeatures * (2 * i + side), contacts);
    }
  }
}

}  // namespace dockyard
