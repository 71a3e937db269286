#include "sim/rigid/convex_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace dockyard {
namespace {

// Two faces that are equally near and all but face away from each other make no ridge: the edge
// pierces the body, and the nearest face is the way out.
constexpr double kLeastRidge = 0.2;

// A function along the edge: value at its first end, and its change to the second.
struct Line {
  double start_m = 0.0, change_m = 0.0;
  int face = -1;

  double At(double share) const { return start_m + share * change_m; }
};

// The least of the faces' depths at a share of the edge; of equal ones that of the least change.
Line LeastAt(const std::vector<Line>& lines, double share) {
  Line least{std::numeric_limits<double>::infinity(), 0.0, -1};
  double depth_m = std::numeric_limits<double>::infinity();
  for (const Line& line : lines) {
    const double here_m = line.At(share);
    if (here_m < depth_m) {
      depth_m = here_m;
      least = line;
    }
  }
  return least;
}

void FindDeepest(const ConvexBody& body, const std::vector<Line>& lines, const Eigen::Vector3d& a,
                 const Eigen::Vector3d& b, PressedEdge& pressed) {
  Line up = LeastAt(lines, pressed.from), down = LeastAt(lines, pressed.to);
  const auto EndAt = [&](double share, const Line& line) {
    pressed.deepest = share;
    pressed.depth_m = line.At(share);
    pressed.normal = body.faces[line.face].normal;
  };
  if (up.change_m <= 0.0) return EndAt(pressed.from, up);
  if (down.change_m >= 0.0) return EndAt(pressed.to, down);
  // A rising and a falling line bound the depth; the least line where they meet is no higher, and
  // takes the place of one of them until it is one of them.
  for (std::size_t i = 0; i <= lines.size(); ++i) {
    const double share = std::clamp((down.start_m - up.start_m) / (up.change_m - down.change_m),
                                    pressed.from, pressed.to);
    const Line least = LeastAt(lines, share);
    pressed.deepest = share;
    if (least.change_m == 0.0) return EndAt(share, least);
    Line& bound = least.change_m > 0.0 ? up : down;
    if (least.face == bound.face || least.At(share) >= bound.At(share)) break;
    bound = least;
  }
  const double of_up = -down.change_m / (up.change_m - down.change_m);
  const Eigen::Vector3d across =
      of_up * body.faces[up.face].normal + (1.0 - of_up) * body.faces[down.face].normal;
  const double size = across.norm();
  if (size < kLeastRidge) return EndAt(pressed.deepest, up);
  pressed.normal = across / size;
  // No further than the ridge of the two faces, were there no others, nor than the body reaches.
  const Eigen::Vector3d p = a + pressed.deepest * (b - a);
  double reach_m = 0.0;
  for (const Eigen::Vector3d& corner : body.vertices) {
    reach_m = std::max(reach_m, pressed.normal.dot(corner - p));
  }
  pressed.depth_m = std::min(up.At(pressed.deepest) / size, reach_m);
}

}  // namespace

ConvexBody operator*(const Pose3& X_AB, const ConvexBody& body_B) {
  ConvexBody body = body_B;
  for (Eigen::Vector3d& p : body.vertices) p = X_AB * p;
  for (HalfSpace& face : body.faces) {
    face.normal = X_AB.R * face.normal;
    face.offset_m += face.normal.dot(X_AB.p);
  }
  body.centre = X_AB * body_B.centre;
  return body;
}

FaceDistance DistanceTo(const ConvexBody& body, const Eigen::Vector3d& p) {
  FaceDistance furthest{-std::numeric_limits<double>::infinity(), {0, 0, 1}};
  for (const HalfSpace& face : body.faces) {
    const double distance_m = face.normal.dot(p) - face.offset_m;
    if (distance_m > furthest.distance_m) furthest = {distance_m, face.normal};
  }
  return furthest;
}

std::optional<double> RayEnters(const ConvexBody& body, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& direction) {
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : body.faces) {
    const double outside_m = face.normal.dot(origin) - face.offset_m;
    const double outward = face.normal.dot(direction);
    if (outward < 0.0) {
      enters = std::max(enters, -outside_m / outward);
    } else if (outward > 0.0) {
      leaves = std::min(leaves, -outside_m / outward);
    } else if (outside_m > 0.0) {
      return std::nullopt;
    }
  }
  return enters > 0.0 && enters <= leaves ? std::optional(enters) : std::nullopt;
}

double DepthAlong(const ConvexBody& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                  double share) {
  return -DistanceTo(body, a + share * (b - a)).distance_m;
}

std::optional<PressedEdge> PressEdge(const ConvexBody& body, const Eigen::Vector3d& a,
                                     const Eigen::Vector3d& b, const std::vector<bool>& far) {
  const Eigen::Vector3d middle = 0.5 * (a + b);
  const double reach_m = body.radius_m + 0.5 * (b - a).norm();
  if ((middle - body.centre).squaredNorm() > reach_m * reach_m) return std::nullopt;
  PressedEdge pressed{.from = 0.0, .to = 1.0};
  std::vector<Line> lines;
  lines.reserve(body.faces.size());
  for (std::size_t i = 0; i < body.faces.size(); ++i) {
    const HalfSpace& face = body.faces[i];
    const double at_a = face.offset_m - face.normal.dot(a),
                 at_b = face.offset_m - face.normal.dot(b);
    if (at_a < 0.0 && at_b < 0.0) return std::nullopt;
    const Line line{at_a, at_b - at_a, static_cast<int>(i)};
    if (at_a < 0.0) pressed.from = std::max(pressed.from, at_a / (at_a - at_b));
    if (at_b < 0.0) pressed.to = std::min(pressed.to, at_a / (at_a - at_b));
    if (pressed.from > pressed.to) return std::nullopt;
    if (far.empty() || !far[i]) lines.push_back(line);
  }
  FindDeepest(body, lines, a, b, pressed);
  return pressed;
}

}  // namespace dockyard
