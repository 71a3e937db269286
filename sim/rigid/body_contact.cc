#include "sim/rigid/body_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dockyard {
namespace {

const double kGauss = 1.0 / std::sqrt(3.0);
// Halvings of the length that is searched: to some micrometres of a metre.
constexpr int kSections = 24, kHalvings = 18;

// The body about the cylinder's axis: along it and across it.
class AboutAxis {
 public:
  AboutAxis(const ConvexBody& body, const Cylinder& cylinder) : body_(body), cylinder_(cylinder) {
    u_ = cylinder.axis.unitOrthogonal();
    v_ = cylinder.axis.cross(u_);
    low_m_ = std::numeric_limits<double>::infinity();
    high_m_ = -low_m_;
    corners_.reserve(body.vertices.size());
    for (const Eigen::Vector3d& p : body.vertices) {
      const Eigen::Vector3d r = p - cylinder.centre;
      corners_.emplace_back(r.dot(u_), r.dot(v_), r.dot(cylinder.axis));
      low_m_ = std::min(low_m_, corners_.back().z());
      high_m_ = std::max(high_m_, corners_.back().z());
    }
  }

  double low_m() const { return low_m_; }
  double high_m() const { return high_m_; }

  /// Place across the axis of the section's point nearest to the axis, the section at this place
  /// along it, and its distance; < 0: the axis is within.
  struct Nearest {
    double distance_m = std::numeric_limits<double>::infinity();
    Eigen::Vector2d at{0, 0};
  };
  Nearest At(double along_m) const {
    Nearest nearest;
    double least = nearest.distance_m;  // square
    for (const auto& t : body_.triangles) {
      Eigen::Vector2d ends[3];
      int count = 0;
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d &a = corners_[t[i]], &b = corners_[t[(i + 1) % 3]];
        if ((a.z() < along_m) == (b.z() < along_m)) continue;
        const double share = (along_m - a.z()) / (b.z() - a.z());
        ends[count++] = a.head<2>() + share * (b - a).head<2>();
      }
      if (count < 2) continue;
      const Eigen::Vector2d way = ends[1] - ends[0];
      const double size = way.squaredNorm();
      const double share = size > 0.0 ? std::clamp(-ends[0].dot(way) / size, 0.0, 1.0) : 0.0;
      const Eigen::Vector2d p = ends[0] + share * way;
      if (p.squaredNorm() >= least) continue;
      least = p.squaredNorm();
      nearest.at = p;
    }
    nearest.distance_m = std::sqrt(least);
    const Eigen::Vector3d on_axis = cylinder_.centre + along_m * cylinder_.axis;
    if (DistanceTo(body_, on_axis).distance_m < 0.0) nearest.distance_m *= -1.0;
    return nearest;
  }
  double Depth(double along_m) const { return cylinder_.radius_m - At(along_m).distance_m; }

  /// From the nearest point towards the axis.
  Eigen::Vector3d Inward(const Nearest& nearest) const {
    return -(nearest.at.x() * u_ + nearest.at.y() * v_) / nearest.distance_m;
  }

 private:
  const ConvexBody& body_;
  const Cylinder& cylinder_;
  Eigen::Vector3d u_, v_;
  std::vector<Eigen::Vector3d> corners_;
  double low_m_ = 0.0, high_m_ = 0.0;
};

// Where the depth is greatest along the axis, by golden sections.
double Deepest(const AboutAxis& about, double low_m, double high_m) {
  constexpr double kGolden = 0.6180339887498949;
  double a = high_m - kGolden * (high_m - low_m), b = low_m + kGolden * (high_m - low_m);
  double at_a = about.Depth(a), at_b = about.Depth(b);
  for (int i = 0; i < kSections; ++i) {
    if (at_a >= at_b) {
      high_m = b;
      b = a;
      at_b = at_a;
      a = high_m - kGolden * (high_m - low_m);
      at_a = about.Depth(a);
    } else {
      low_m = a;
      a = b;
      at_a = at_b;
      b = low_m + kGolden * (high_m - low_m);
      at_b = about.Depth(b);
    }
  }
  return 0.5 * (low_m + high_m);
}

// Where the depth passes through 0 between a place within and one that may be outside.
double PressedEnd(const AboutAxis& about, double within_m, double outside_m) {
  if (about.Depth(outside_m) > 0.0) return outside_m;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_m = 0.5 * (within_m + outside_m);
    (about.Depth(middle_m) > 0.0 ? within_m : outside_m) = middle_m;
  }
  return within_m;
}

bool IsApart(const ConvexBody& body, const Cylinder& cylinder) {
  const Eigen::Vector3d between = cylinder.centre - body.centre;
  const double reach_m = body.radius_m + std::hypot(cylinder.radius_m, cylinder.half_m);
  if (between.squaredNorm() > reach_m * reach_m) return true;
  for (const HalfSpace& face : body.faces) {
    const double along = face.normal.dot(cylinder.axis);
    const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
    const double lowest_m = face.normal.dot(cylinder.centre) - std::abs(along) * cylinder.half_m -
                            across * cylinder.radius_m;
    if (lowest_m > face.offset_m) return true;
  }
  return false;
}

// Two faces are on opposite sides if their normals are further apart than 120 deg.
constexpr double kOpposite = -0.5;

// How far the body's points reach behind a face.
double ReachBehind(const HalfSpace& face, const ConvexBody& body) {
  double reach_m = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : body.vertices) {
    reach_m = std::max(reach_m, face.offset_m - face.normal.dot(p));
  }
  return reach_m;
}

// The body's faces on its far side from a part: the part reaches out of the body behind them, and
// behind a face on the opposite side it does not. Empty: there are none.
std::vector<bool> FarFaces(const ConvexBody& body, const ConvexBody& part) {
  std::vector<bool> through;
  for (const HalfSpace& face : body.faces) {
    through.push_back(ReachBehind(face, part) >= ReachBehind(face, body));
  }
  std::vector<bool> far(through.size());
  bool any = false;
  for (std::size_t i = 0; i < through.size(); ++i) {
    for (std::size_t k = 0; k < through.size() && through[i] && !far[i]; ++k) {
      far[i] = !through[k] && body.faces[i].normal.dot(body.faces[k].normal) < kOpposite;
    }
    any = any || far[i];
  }
  if (!any) far.clear();
  return far;
}

// A part's edges in a body. Its far faces are searched once an edge meets it.
class EdgesIn {
 public:
  EdgesIn(const ConvexBody& body, const ConvexBody& part) : body_(body), part_(part) {}

  std::optional<PressedEdge> Press(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const std::optional<PressedEdge> in = PressEdge(body_, a, b);
    if (!in || in->depth_m <= 0.0) return std::nullopt;
    if (!known_) far_ = FarFaces(body_, part_);
    known_ = true;
    return far_.empty() ? in : PressEdge(body_, a, b, far_);
  }

 private:
  const ConvexBody &body_, &part_;
  std::vector<bool> far_;
  bool known_ = false;
};

}  // namespace

void AddCylinderContacts(const ConvexBody& body, const Cylinder& cylinder, int feature,
                         std::vector<BodyContact>& contacts) {
  if (IsApart(body, cylinder)) return;
  const AboutAxis about(body, cylinder);
  const double half_m = cylinder.half_m;
  const double low_m = std::max(-half_m, about.low_m()), high_m = std::min(half_m, about.high_m());
  if (low_m >= high_m) return;
  const double deepest_m = Deepest(about, low_m, high_m), most_m = about.Depth(deepest_m);
  if (most_m <= 0.0) return;
  const double from_m = PressedEnd(about, deepest_m, low_m);
  const double to_m = PressedEnd(about, deepest_m, high_m);
  const double middle_m = 0.5 * (from_m + to_m), gauss_m = 0.5 * kGauss * (to_m - from_m);
  const double at_m[2] = {middle_m - gauss_m, middle_m + gauss_m};
  const AboutAxis::Nearest nearest[2] = {about.At(at_m[0]), about.At(at_m[1])};

  // How the body falls away along the axis, as far as the cylinder's own edge is pressed in there.
  double fall =
      gauss_m > 0.0 ? (nearest[1].distance_m - nearest[0].distance_m) / (2.0 * gauss_m) : 0.0;
  const double end_m = fall > 0.0 ? -half_m : half_m;
  const bool has_end = fall > 0.0 ? from_m <= -half_m : to_m >= half_m;
  fall *= has_end ? std::clamp(about.Depth(end_m) / most_m, 0.0, 1.0) : 0.0;
  const double size = std::hypot(1.0, fall);

  // Out by an end of the cylinder: along the axis.
  const double by_low_m = about.low_m() <= -half_m ? to_m + half_m : most_m;
  const double by_high_m = about.high_m() >= half_m ? half_m - from_m : most_m;
  const double by_end_m = std::min(by_low_m, by_high_m);
  if (by_end_m < most_m / size) {
    const double side = by_low_m <= by_high_m ? 1.0 : -1.0;
    const Eigen::Vector3d on_axis = cylinder.centre + middle_m * cylinder.axis;
    const AboutAxis::Nearest there = about.At(middle_m);
    const Eigen::Vector3d aside = there.distance_m > 0.0
                                      ? Eigen::Vector3d(-there.distance_m * about.Inward(there))
                                      : Eigen::Vector3d(0, 0, 0);
    contacts.push_back({feature, on_axis + aside, side * cylinder.axis, by_end_m, 1.0});
    return;
  }
  for (int i = 0; i < 2; ++i) {
    const double depth_m = cylinder.radius_m - nearest[i].distance_m;
    if (depth_m <= 0.0 || nearest[i].distance_m == 0.0) continue;
    const Eigen::Vector3d inward = about.Inward(nearest[i]);
    contacts.push_back({feature + i,
                        cylinder.centre + at_m[i] * cylinder.axis - cylinder.radius_m * inward,
                        (inward + fall * cylinder.axis) / size, depth_m / size, 0.5});
  }
}

void AddEdgeContacts(const ConvexBody& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     int feature, std::vector<BodyContact>& contacts) {
  const std::optional<PressedEdge> pressed = PressEdge(body, a, b);
  if (!pressed) return;
  const double most_m = DepthAlong(body, a, b, pressed->deepest);
  if (most_m <= 0.0) return;
  const double middle = 0.5 * (pressed->from + pressed->to);
  const double gauss = 0.5 * kGauss * (pressed->to - pressed->from);
  for (int i = 0; i < 2; ++i) {
    const double share = i == 0 ? middle - gauss : middle + gauss;
    const double depth_m = DepthAlong(body, a, b, share) * (pressed->depth_m / most_m);
    if (depth_m <= 0.0) continue;
    contacts.push_back({feature + i, a + share * (b - a), pressed->normal, depth_m, 0.5});
  }
}

void AddHullContacts(const ConvexBody& body, const ConvexBody& part, int feature,
                     std::vector<BodyContact>& contacts) {
  const double reach_m = body.radius_m + part.radius_m;
  if ((body.centre - part.centre).squaredNorm() > reach_m * reach_m) return;
  EdgesIn in_body(body, part), in_part(part, body);
  for (const auto& edge : part.edges) {
    const Eigen::Vector3d &a = part.vertices[edge[0]], &b = part.vertices[edge[1]];
    if (const std::optional<PressedEdge> in = in_body.Press(a, b)) {
      contacts.push_back({feature, a + in->deepest * (b - a), in->normal, in->depth_m, 1.0});
    }
    ++feature;
  }
  for (const auto& edge : body.edges) {
    const Eigen::Vector3d &a = body.vertices[edge[0]], &b = body.vertices[edge[1]];
    const std::optional<PressedEdge> in = in_part.Press(a, b);
    // Edge against edge is among the part's.
    if (in && (in->deepest == 0.0 || in->deepest == 1.0)) {
      contacts.push_back({feature, a + in->deepest * (b - a), -in->normal, in->depth_m, 1.0});
    }
    ++feature;
  }
}

}  // namespace dockyard
