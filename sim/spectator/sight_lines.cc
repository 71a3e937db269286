#include "sim/spectator/sight_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace dockyard {
namespace {

/// A line between two points, in the frame of a part.
struct Line {
  Eigen::Vector3d from, step;  // its end is from + step
};

Line Moved(const Pose3& X, const Line& line) { return {X * line.from, X.R * line.step}; }

bool ComesWithin(const Line& line, const Eigen::Vector3d& middle, double radius_m) {
  const Eigen::Vector3d to = middle - line.from;
  const double share = std::clamp(to.dot(line.step) / line.step.squaredNorm(), 0.0, 1.0);
  return (to - share * line.step).squaredNorm() <= radius_m * radius_m;
}

bool Meets(const Line& line, const Eigen::AlignedBox3d& box) {
  double begin = 0.0, end = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = line.step(axis);
    double low = box.min()(axis) - line.from(axis), high = box.max()(axis) - line.from(axis);
    if (std::abs(along) < 1e-12) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    low /= along;
    high /= along;
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  return begin <= end;
}

/// Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997; from both sides.
bool Meets(const Line& line, const std::array<Eigen::Vector3d, 3>& triangle) {
  const Eigen::Vector3d a = triangle[1] - triangle[0], b = triangle[2] - triangle[0];
  const Eigen::Vector3d across = line.step.cross(b);
  const double volume = a.dot(across);
  if (volume == 0.0) return false;
  const Eigen::Vector3d to = line.from - triangle[0], up = to.cross(a);
  const double u = to.dot(across) / volume, v = line.step.dot(up) / volume;
  const double share = b.dot(up) / volume;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && share >= 0.0 && share <= 1.0;
}

bool Meets(const Line& line, const RenderMesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& corners) {
    return Meets(line, {mesh.vertices[corners[0]].template cast<double>(),
                        mesh.vertices[corners[1]].template cast<double>(),
                        mesh.vertices[corners[2]].template cast<double>()});
  });
}

std::vector<Eigen::Vector3d> CornersOf(const Eigen::AlignedBox3d& box) {
  std::vector<Eigen::Vector3d> corners;
  if (box.isEmpty()) return corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  }
  return corners;
}

}  // namespace

SightLines::Part SightLines::PartOf(const StagePart& drawn) {
  Part part{.mesh = drawn.mesh.get(), .X_OP = drawn.X_OP, .X_PO = Inverse(drawn.X_OP), .box_P = {}};
  for (const Eigen::Vector3f& vertex : drawn.mesh->vertices) {
    part.box_P.extend(vertex.cast<double>());
  }
  if (part.box_P.isEmpty()) return part;
  part.middle_O = part.X_OP * part.box_P.center();
  part.reach_m = 0.5 * part.box_P.diagonal().norm();
  return part;
}

SightLines::SightLines(const LoggedRun& run, const StageShapes& shapes) : run_(run) {
  for (const StageBody& body : shapes.bodies) {
    const auto at = std::find(run.body_names.begin(), run.body_names.end(), body.name);
    if (at == run.body_names.end()) throw DataError("the log has no body " + body.name);
    Body known{&body, static_cast<std::size_t>(at - run.body_names.begin()), {}};
    for (const StagePart& drawn : body.parts) known.parts.push_back(PartOf(drawn));
    bodies_.push_back(std::move(known));
  }
}

bool SightLines::Blocked(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
                         std::size_t sample, const Which& which) const {
  const Line line_W{from_W, to_W - from_W};
  for (const Body& body : bodies_) {
    if (!which(*body.shape)) continue;
    const Line line_O = Moved(Inverse(run_.X_WO[body.place][sample]), line_W);
    for (const Part& part : body.parts) {
      if (!ComesWithin(line_O, part.middle_O, part.reach_m)) continue;
      const Line line_P = Moved(part.X_PO, line_O);
      if (Meets(line_P, part.box_P) && Meets(line_P, *part.mesh)) return true;
    }
  }
  return false;
}

double SightLines::RobotDistance_m(const Eigen::Vector3d& p_W, std::size_t sample) const {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Body& body : bodies_) {
    if (!body.shape->robot) continue;
    const Eigen::Vector3d p_O = Inverse(run_.X_WO[body.place][sample]) * p_W;
    for (const Part& part : body.parts) {
      if (part.box_P.isEmpty()) continue;
      least_m = std::min(least_m, part.box_P.exteriorDistance(part.X_PO * p_O));
    }
  }
  return least_m;
}

double SightLines::Reach_m(const std::string& name) const {
  double reach_m = 0.0;
  for (const Body& body : bodies_) {
    if (body.shape->name != name) continue;
    for (const Part& part : body.parts) {
      for (const Eigen::Vector3d& corner : CornersOf(part.box_P)) {
        reach_m = std::max(reach_m, (part.X_OP * corner).norm());
      }
    }
  }
  return reach_m;
}

std::vector<Eigen::Vector3d> SightLines::RobotCorners_W(std::size_t sample) const {
  Eigen::AlignedBox3d box;
  for (const Body& body : bodies_) {
    if (!body.shape->robot) continue;
    for (const Part& part : body.parts) {
      const Pose3 X_WP = run_.X_WO[body.place][sample] * part.X_OP;
      for (const Eigen::Vector3d& corner : CornersOf(part.box_P)) box.extend(X_WP * corner);
    }
  }
  return CornersOf(box);
}

}  // namespace dockyard
