// What hides a board of marks, and what lies before a pin or a pad: both along a line that leaves
// the part straight ahead.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "controller/base/number_text.h"
#include "sim/custom/findings.h"
#include "sim/custom/tree_in_world.h"
#include "sim/vehicles/spring_pins.h"

namespace dockyard::custom {
namespace {

using Eigen::Vector3d;

constexpr double kFar_m = 10.0;  // longer than a solid; numerical
// No camera comes between a board and what is as near before it. Assumed, 0.1-0.5 m.
constexpr double kBefore_m = 0.2;
// Nothing that presses on a pin comes between it and a wall so near before it. Assumed, 2-10 mm.
constexpr double kNear_m = 0.005;
// A wall may cover a pin's tip by this: contacts yield. Assumed, 0.2-2 mm.
constexpr double kCovered_m = 1e-3;

/// How far ahead the line from p along a unit vector meets a triangle; none: it does not.
std::optional<double> Ahead(const Vector3d& p, const Vector3d& along, const Vector3d& a,
                            const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, across = along.cross(ac);
  const double det = ab.dot(across);
  if (std::abs(det) < 1e-15) return std::nullopt;
  const Vector3d ap = p - a, turned = ap.cross(ab);
  const double u = ap.dot(across) / det, v = along.dot(turned) / det;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
  return ac.dot(turned) / det;
}

/// Of a part that is drawn, in the root's frame.
double NearestAhead(const Visual& visual, const Pose3& X_RL, const Vector3d& p_R,
                    const Vector3d& along_R) {
  constexpr double kTouches_m = 1e-6;
  const Pose3 X_VR = Inverse(X_RL * visual.X_LV);
  const Vector3d p = X_VR * p_R, along = X_VR.R * along_R;
  const TriangleMesh& mesh = *visual.mesh;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const auto at_m =
        Ahead(p, along, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    if (at_m && *at_m >= -kTouches_m) nearest_m = std::min(nearest_m, *at_m);
  }
  return nearest_m;
}

/// Middles of discs, middles and corners of tags.
std::vector<Eigen::Vector2d> PointsOf(const FiducialBoard& board) {
  std::vector<Eigen::Vector2d> points;
  for (const Fiducial& mark : board.fiducials) points.push_back(mark.p_BF);
  for (const SquareTag& tag : board.tags) {
    points.push_back(tag.p_BT);
    for (const Eigen::Vector2d& corner : CornersOf(tag)) points.push_back(corner);
  }
  return points;
}

/// What lies before a board's marks.
struct Cover {
  std::string by;  // a link
  std::size_t points = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
};

Cover CoverBy(const LinkModel& link, const Pose3& X_DL, const Pose3& X_DB,
              const std::vector<Eigen::Vector2d>& points) {
  Cover cover{.by = link.name};
  const Vector3d out_D = -X_DB.R.col(2);
  for (const Eigen::Vector2d& p : points) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const Visual& visual : link.visuals) {
      nearest_m = std::min(nearest_m,
                           NearestAhead(visual, X_DL, X_DB * Vector3d(p.x(), p.y(), 0.0), out_D));
    }
    cover.nearest_m = std::min(cover.nearest_m, nearest_m);
    if (nearest_m <= kBefore_m) ++cover.points;
  }
  return cover;
}

/// How far out along a line, counted from p, the foremost of the link's solids reaches that begin
/// before kNear_m ahead; none: there is none.
std::optional<double> SurfaceAhead(const std::vector<LinkSolid>& solids, int link,
                                   const Vector3d& p_L, const Vector3d& out_L) {
  std::optional<double> surface_m;
  for (const LinkSolid& solid : solids) {
    if (solid.link != link) continue;
    const auto in = PressEdge(solid.body_L, p_L - kFar_m * out_L, p_L + kFar_m * out_L);
    if (!in || in->to <= in->from) continue;
    const double begins_m = (2.0 * in->from - 1.0) * kFar_m, ends_m = (2.0 * in->to - 1.0) * kFar_m;
    if (begins_m <= kNear_m) surface_m = std::max(surface_m.value_or(ends_m), ends_m);
  }
  return surface_m;
}

std::string Millimetres(double length_m) { return Fixed(1e3 * length_m, 1) + " mm"; }

}  // namespace

Findings FindHiddenBoards(const DockModel& dock, const std::string& file) {
  Findings findings;
  const std::vector<Pose3> X_DL = StartPoses(dock.tree);
  for (std::size_t i = 0; i < dock.boards.size(); ++i) {
    const BoardFit& fit = dock.boards[i];
    const Pose3 X_DB = X_DL[static_cast<std::size_t>(fit.link)] * fit.X_LB;
    const std::vector<Eigen::Vector2d> points = PointsOf(fit.board);
    for (int k = 0; k < dock.tree.link_count(); ++k) {
      const Cover cover =
          CoverBy(dock.tree.link(k), X_DL[static_cast<std::size_t>(k)], X_DB, points);
      if (cover.points == 0) continue;
      // A link that a joint moves may uncover it.
      const bool always = k == fit.link && cover.points == points.size();
      (always ? findings.faults : findings.doubts)
          .push_back(PlaceOfKey(file, "boards", i, "middle_m") + ": expected the board '" +
                     fit.name + "' before the dock's parts, found " +
                     (cover.points == points.size() ? "all" : "some") +
                     " of its marks hidden by '" + cover.by + "', " +
                     Millimetres(std::max(0.0, cover.nearest_m)) +
                     " before it; put it further out, or turn it with "
                     "yaw_deg" +
                     kWhatIsChecked);
    }
  }
  return findings;
}

Findings FindOutOfReach(const LinkTree& tree, const ElectricalParts& parts,
                        const std::string& file) {
  Findings findings;
  if (parts.pins.empty() && parts.pads.empty()) return findings;
  const std::vector<LinkSolid> solids = SolidsOf(tree);
  const auto add = [&](const char* list, std::size_t i, const char* key, const std::string& text) {
    findings.faults.push_back(PlaceOfKey(file, list, i, key) + ": " + text + kWhatIsChecked);
  };
  for (std::size_t i = 0; i < parts.pins.size(); ++i) {
    const SpringPin& pin = parts.pins[i];
    const LinkModel& link = tree.link(pin.link);
    const auto surface_m = SurfaceAhead(solids, pin.link, pin.p_L, pin.out_L);
    if (!surface_m || *surface_m <= kCovered_m) continue;
    add("contact_pins", i, "tip_m",
        "expected a tip outside '" + link.name + "', found it covered: the wall ends " +
            Millimetres(*surface_m) + " before it, so nothing can press it in");
  }
  for (std::size_t i = 0; i < parts.pads.size(); ++i) {
    const ContactPad& pad = parts.pads[i];
    const LinkModel& link = tree.link(pad.link);
    const auto surface_m = SurfaceAhead(solids, pad.link, pad.X_LP.p, pad.X_LP.R.col(2));
    if (surface_m && std::abs(*surface_m) <= kOffPad_m) continue;
    const std::string expected = "expected a pad within " + Millimetres(kOffPad_m) +
                                 " of the surface of '" + link.name + "', found ";
    add("contact_pads", i, "middle_m",
        expected + (!surface_m ? "no solid behind it: pins go through"
                    : *surface_m > 0.0
                        ? "it " + Millimetres(*surface_m) + " deep in it: pins do not reach it"
                        : "it " + Millimetres(-*surface_m) + " before it: pins go through"));
  }
  return findings;
}

}  // namespace dockyard::custom
