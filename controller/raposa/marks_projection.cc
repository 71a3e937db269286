#include "controller/raposa/marks_projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr double kNearest_m = 0.03;  // before the camera; nearer parts have no sound image
constexpr int kRim = 16, kEnd = 6;   // corners round the guide's widest place and its ends

class Projector {
 public:
  Projector(const Camera& camera, const Pose3& X_CP) : camera_(camera), X_CP_(X_CP) {}

  void Add(const Eigen::Vector3d& p_P, ConvexPolygon* polygon) {
    const Eigen::Vector3d p_C = X_CP_ * p_P;
    const auto pixel = p_C.z() < kNearest_m ? std::nullopt : camera_.Project(p_C);
    if (!pixel) {
      failed_ = true;
      return;
    }
    polygon->Add(*pixel);
  }
  ConvexPolygon Polygon(const std::array<Eigen::Vector3d, 4>& corners_P) {
    ConvexPolygon polygon;
    for (const Eigen::Vector3d& p : corners_P) Add(p, &polygon);
    return polygon;
  }
  /// The camera's centre in P.
  Eigen::Vector3d Eye() const { return -(X_CP_.R.transpose() * X_CP_.p); }
  bool failed() const { return failed_; }

 private:
  const Camera& camera_;
  Pose3 X_CP_;
  bool failed_ = false;
};

/// Two cones base to base about an axis that points up by guide_up_rad: the hull of three circles.
ConvexPolygon Guide(const Marks& marks, Projector* projector) {
  const double radius_m = 0.5 * marks.guide_diameter_m;
  const double slope = std::tan(marks.guide_half_angle_rad);
  const double front_m =
      std::min(0.5 * marks.guide_length_m, (radius_m - marks.guide_blunt_radius_m) / slope);
  const double rear_m =
      std::min(0.5 * marks.guide_length_m, (radius_m - marks.rod_radius_m) / slope);
  const double c = std::cos(marks.guide_up_rad), s = std::sin(marks.guide_up_rad);
  const Eigen::Vector3d axis(c, 0.0, s), up(-s, 0.0, c), left(0.0, 1.0, 0.0);
  ConvexPolygon points;
  const auto ring = [&](double along_m, double r_m, int count) {
    for (int k = 0; k < count; ++k) {
      const double turn = 2.0 * kPi * k / count;
      projector->Add(along_m * axis + r_m * (std::cos(turn) * left + std::sin(turn) * up), &points);
    }
  };
  ring(0.0, radius_m, kRim);
  ring(front_m, radius_m - slope * front_m, kEnd);
  ring(-rear_m, radius_m - slope * rear_m, kEnd);
  return HullOf(points);
}

/// The tip of the faces.
double ApexX_m(const Marks& marks) {
  return -marks.behind_m + marks.strip_m + 0.5 * marks.edge_m * std::tan(marks.rise_rad);
}

/// As a flat band across the line of sight.
ConvexPolygon Rod(const Marks& marks, Projector* projector) {
  const double apex_m = ApexX_m(marks);  // where it meets the faces
  const double tan_up = std::tan(marks.guide_up_rad);
  const Eigen::Vector3d near_P(0.0, 0.0, 0.0), far_P(apex_m, 0.0, apex_m * tan_up);
  const Eigen::Vector3d across =
      (far_P - near_P).cross(projector->Eye() - near_P).normalized() * marks.rod_radius_m;
  return projector->Polygon({near_P + across, far_P + across, far_P - across, near_P - across});
}

/// An upright square, counter-clockwise as the guide sees it.
std::array<Eigen::Vector3d, 4> Square(double x_m, double half_m) {
  return {Eigen::Vector3d(x_m, -half_m, -half_m), Eigen::Vector3d(x_m, half_m, -half_m),
          Eigen::Vector3d(x_m, half_m, half_m), Eigen::Vector3d(x_m, -half_m, half_m)};
}

/// Sides and faces that the camera sees, with the paint on them.
void AddFaces(const Marks& marks, Projector* projector, MarksInImage* out) {
  const double half_m = 0.5 * marks.edge_m, edge_m = -marks.behind_m + marks.strip_m;
  const auto rear = Square(-marks.behind_m, half_m), outer = Square(edge_m, half_m);
  const auto inner = Square(edge_m + marks.strip_m * std::sin(marks.rise_rad),
                            half_m - marks.strip_m * std::cos(marks.rise_rad));
  const Eigen::Vector3d apex(ApexX_m(marks), 0.0, 0.0);
  const auto visible = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c) {
    return (b - a).cross(c - a).dot(projector->Eye() - a) > 0.0;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    if (visible(rear[k], rear[next], outer[k])) {
      out->strips.push_back(projector->Polygon({rear[k], rear[next], outer[next], outer[k]}));
    }
    if (!visible(outer[k], outer[next], apex)) continue;
    out->strips.push_back(projector->Polygon({outer[k], outer[next], inner[next], inner[k]}));
    out->faces.push_back(projector->Polygon({inner[k], inner[next], apex, apex}));
  }
}

ConvexPolygon Box(const GreyBox& box, Projector* projector) {
  ConvexPolygon points;
  for (int corner = 0; corner < 8; ++corner) {
    projector->Add(
        {(corner & 1) ? box.high.x() : box.low.x(), (corner & 2) ? box.high.y() : box.low.y(),
         (corner & 4) ? box.high.z() : box.low.z()},
        &points);
  }
  return projector->failed() ? points : HullOf(points);
}

}  // namespace

Pose3 CameraToPyramid(const PyramidPlace& place) {
  Eigen::Matrix3d R_CV;  // level: right, down, along the view
  R_CV << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Pose3 X_CV{RotZ(-place.roll_rad) * RotX(place.pitch_rad) * R_CV, Eigen::Vector3d::Zero()};
  return X_CV * FromGround(place.X_VD, -place.down_m);
}

std::optional<MarksInImage> ProjectGuide(const Nominal& nominal, const PyramidPlace& place) {
  Projector projector(nominal.camera, CameraToPyramid(place));
  MarksInImage out;
  ConvexPolygon middle;
  projector.Add(Eigen::Vector3d::Zero(), &middle);
  if (projector.failed()) return std::nullopt;
  out.guide_px = middle.corners[0];
  out.guide = Guide(nominal.marks, &projector);
  if (projector.failed()) return std::nullopt;
  return out;
}

std::optional<MarksInImage> ProjectMarks(const Nominal& nominal, const PyramidPlace& place) {
  std::optional<MarksInImage> out = ProjectGuide(nominal, place);
  if (!out) return std::nullopt;
  Projector projector(nominal.camera, CameraToPyramid(place));
  out->rod = Rod(nominal.marks, &projector);
  AddFaces(nominal.marks, &projector, &*out);
  for (const GreyBox& box : nominal.grey_boxes) out->boxes.push_back(Box(box, &projector));
  if (projector.failed()) return std::nullopt;
  return out;
}

}  // namespace dockyard::raposa
