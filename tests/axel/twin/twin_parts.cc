#include "axel/twin/twin_parts.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "sim/axel/cone_shapes.h"

namespace dockyard::axel {
namespace {

constexpr int kSectors = 24;
// Arm and cone meet each other alone, as the wheels do the ground.
constexpr const char* kMeets = "\" contype=\"2\" conaffinity=\"2\"/>\n";

using Points = std::vector<Eigen::Vector3d>;

class Words {
 public:
  Words() { out_.precision(17); }
  template <typename T>
  Words& operator<<(const T& value) {
    out_ << value;
    return *this;
  }
  Words& operator<<(const Eigen::Vector3d& v) {
    out_ << v.x() << ' ' << v.y() << ' ' << v.z();
    return *this;
  }
  std::string text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

std::string At(const Pose3& X) {
  const Eigen::Quaterniond q(X.R);
  Words words;
  words << "\" pos=\"" << X.p << "\" quat=\"" << q.w() << ' ' << q.x() << ' ' << q.y() << ' '
        << q.z();
  return words.text();
}

std::string Mesh(const std::string& name, const Points& points) {
  Words words;
  words << "<mesh name=\"" << name << "\" vertex=\"";
  for (const Eigen::Vector3d& p : points) words << p << ' ';
  words << "\"/>\n";
  return words.text();
}

std::string MeshGeom(const std::string& name, const Pose3& X) {
  return "<geom type=\"mesh\" mesh=\"" + name + At(X) + kMeets;
}

Eigen::Vector3d InMouth(double x_m, double r_m, double angle_rad) {
  return {x_m, r_m * std::cos(angle_rad), r_m * std::sin(angle_rad)};
}

// A ring's sector between two radii at either end.
Points Sector(int index, double x0, double inner0, double x1, double inner1, double outer) {
  Points points;
  for (const int side : {index, index + 1}) {
    const double angle = 2.0 * kPi * side / kSectors;
    for (const auto& [x, r] : {std::pair(x0, inner0), {x0, outer}, {x1, inner1}, {x1, outer}}) {
      points.push_back(InMouth(x, r, angle));
    }
  }
  return points;
}

double Lowest(const HeightGrid& grid) {
  return *std::min_element(grid.heights_m.begin(), grid.heights_m.end());
}
double Highest(const HeightGrid& grid) {
  return *std::max_element(grid.heights_m.begin(), grid.heights_m.end());
}

}  // namespace

std::string HeightFieldAsset(const HeightGrid& grid) {
  Words words;
  words << "<hfield name=\"ground\" nrow=\"" << grid.ny << "\" ncol=\"" << grid.nx << "\" size=\""
        << 0.5 * (grid.nx - 1) * grid.cell_m << ' ' << 0.5 * (grid.ny - 1) * grid.cell_m << ' '
        << std::max(Highest(grid) - Lowest(grid), 1e-3) << " 0.1\"/>\n";
  return words.text();
}

std::string HeightFieldGeom(const HeightGrid& grid) {
  const Eigen::Vector3d middle(grid.x0_m + 0.5 * (grid.nx - 1) * grid.cell_m,
                               grid.y0_m + 0.5 * (grid.ny - 1) * grid.cell_m, Lowest(grid));
  Words words;
  words << "<geom type=\"hfield\" hfield=\"ground\" pos=\"" << middle
        << "\" contype=\"1\" conaffinity=\"1\"/>\n";
  return words.text();
}

void TakeHeights(const HeightGrid& grid, mjModel& model) {
  const double low = Lowest(grid), range = std::max(Highest(grid) - low, 1e-3);
  for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
    model.hfield_data[i] = static_cast<float>((grid.heights_m[i] - low) / range);
  }
}

std::string ConeMeshes(const ConeModel& cone) {
  std::string xml;
  const double funnel = -cone.funnel_length_m, outer = cone.face_outer_radius_m;
  for (int i = 0; i < kSectors; ++i) {
    xml += Mesh("funnel" + std::to_string(i),
                Sector(i, 0.0, cone.mouth_radius_m, funnel, cone.throat_radius_m, outer));
    xml += Mesh(
        "socket" + std::to_string(i),
        Sector(i, funnel, cone.throat_radius_m, -cone.socket_end_m, cone.throat_radius_m, outer));
  }
  return xml;
}

std::string ConeBody(const ConeModel& cone, const Pose3& X_GM) {
  Words words;
  words << "<body name=\"cone" << At(X_GM) << "\">\n";
  for (int i = 0; i < kSectors; ++i) {
    words << MeshGeom("funnel" + std::to_string(i), {})
          << MeshGeom("socket" + std::to_string(i), {});
  }
  if (cone.stop_depth_m > 0.0) {
    constexpr double kHalf_m = 0.015;
    words << "<geom type=\"box\" size=\"" << kHalf_m << ' ' << cone.throat_radius_m << ' '
          << cone.throat_radius_m << At(Pose3::Translation(-cone.stop_depth_m - kHalf_m, 0.0, 0.0))
          << kMeets;
  }
  words << "</body>\n";
  return words.text();
}

std::string ArmMeshes(const RoverModel& rover) {
  std::string xml;
  for (const Collision& part : ArmCollisions(rover)) {
    Points points;
    if (const auto* turned = std::get_if<TurnedShape>(&part.shape)) {
      for (const Eigen::Vector2d& rim : turned->profile_m) {
        for (int i = 0; i < kSectors; ++i) {
          const double angle = 2.0 * kPi * i / kSectors;
          points.emplace_back(rim.y() * std::cos(angle), rim.y() * std::sin(angle), rim.x());
        }
      }
    } else if (const auto* hull = std::get_if<HullShape>(&part.shape)) {
      points.assign(hull->points.begin(), hull->points.end());
    }
    if (!points.empty()) xml += Mesh("arm_" + part.name, points);
  }
  return xml;
}

std::string ArmGeoms(const RoverModel& rover) {
  Words words;
  for (const Collision& part : ArmCollisions(rover)) {
    if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
      words << "<geom type=\"cylinder\" size=\"" << cylinder->radius_m << ' '
            << 0.5 * cylinder->length_m << At(part.X_LG) << kMeets;
    } else if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) {
      words << "<geom type=\"sphere\" size=\"" << sphere->radius_m << At(part.X_LG) << kMeets;
    } else if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
      words << "<geom type=\"box\" size=\"" << Eigen::Vector3d(0.5 * box->size_m) << At(part.X_LG)
            << kMeets;
    } else {
      words << MeshGeom("arm_" + part.name, part.X_LG);
    }
  }
  return words.text();
}

}  // namespace dockyard::axel
