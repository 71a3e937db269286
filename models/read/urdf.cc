#include "models/read/urdf.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "controller/geometry/decompositions.h"
#include "models/read/config_error.h"
#include "models/read/mesh_loader.h"
#include "models/read/text_file.h"
#include "models/read/urdf_check.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr double kMaxLength_m = 100.0;
constexpr double kMaxMass_kg = 1e5;

[[noreturn]] void Refuse(const std::string& place, const std::string& what) {
  throw ConfigError(place + ": " + what);
}

double Checked(double value, const Range& range, const std::string& place,
               const std::string& what) {
  const bool fits = range.open_low ? value > range.low : value >= range.low;
  if (fits && value <= range.high) return value;
  Refuse(place, what + ": expected " + Describe(range, value > range.high) + ", found '" +
                    NumberText(value) + "'");
}

Eigen::Vector3d ToVector(const urdf::Vector3& v, double limit, const std::string& place,
                         const std::string& what) {
  for (const double x : {v.x, v.y, v.z}) Checked(x, Between(-limit, limit), place, what);
  return {v.x, v.y, v.z};
}

Pose3 ToPose(const urdf::Pose& pose, const std::string& place, const std::string& what) {
  const urdf::Rotation& r = pose.rotation;
  const Eigen::Quaterniond q(r.w, r.x, r.y, r.z);
  if (!(std::abs(q.norm() - 1.0) < 1e-6)) Refuse(place, what + ": expected finite angles in rpy");
  return {q.normalized().toRotationMatrix(),
          ToVector(pose.position, kMaxLength_m, place, what + " origin")};
}

void ReadInertial(const urdf::Inertial& in, const std::string& place, LinkModel& link) {
  link.mass_kg = Checked(in.mass, Positive(kMaxMass_kg), place, "mass");
  const Pose3 X_LI = ToPose(in.origin, place, "inertial");
  Eigen::Matrix3d I;
  I << in.ixx, in.ixy, in.ixz, in.ixy, in.iyy, in.iyz, in.ixz, in.iyz, in.izz;
  if (!I.allFinite() || I.cwiseAbs().maxCoeff() > 1e6) {
    Refuse(place, "inertia: expected finite numbers up to 1e6 kg m^2");
  }
  link.p_LoCom_L = X_LI.p;
  link.I_LCom_L = X_LI.R * I * X_LI.R.transpose();
  const Eigen::Vector3d moments = EigenOfSymmetric(I).values;
  const bool possible = moments[0] > 0.0 && moments[0] + moments[1] >= moments[2] * (1.0 - 1e-6);
  if (!possible) {
    Refuse(place,
           "inertia: expected principal moments > 0 of which none exceeds the sum of the others");
  }
}

/// The totals over all links of one file, and the meshes that it has named already.
struct Budget {
  std::size_t parts = 2000, corners = 6 * kMaxMeshTriangles;
  std::map<std::string, std::shared_ptr<const TriangleMesh>> meshes{};  // by path
  MeshStore* store = nullptr;                                           // as of LoadUrdf
};

/// A cylinder, box or sphere as a mesh; a mesh from its file.
std::shared_ptr<const TriangleMesh> ReadMesh(const urdf::Geometry& geometry,
                                             const std::string& place, const std::string& file,
                                             Budget& left) {
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const auto& box = static_cast<const urdf::Box&>(geometry);
      return std::make_shared<const TriangleMesh>(
          BoxMesh(ToVector(box.dim, kMaxLength_m, place, "box size")));
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      return std::make_shared<const TriangleMesh>(CylinderMesh(cylinder.radius, cylinder.length));
    }
    case urdf::Geometry::SPHERE:
      return std::make_shared<const TriangleMesh>(
          SphereMesh(static_cast<const urdf::Sphere&>(geometry).radius));
    case urdf::Geometry::MESH:
      break;
  }
  const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
  const Eigen::Vector3d scale = ToVector(mesh.scale, 1e4, place, "mesh scale");
  if (scale.cwiseAbs().minCoeff() < 1e-6) {
    Refuse(place, "mesh scale: expected numbers other than 0");
  }
  const auto path = ResolveInside(file, mesh.filename, place + ": mesh filename");
  std::shared_ptr<const TriangleMesh>& loaded = left.meshes[path.string()];
  if (!loaded) loaded = LoadMesh(path, left.store);
  if (scale == Eigen::Vector3d::Ones()) return loaded;
  return std::make_shared<const TriangleMesh>(Scaled(*loaded, scale));
}

void CheckShape(const urdf::Geometry& geometry, const std::string& place) {
  const Range length = Positive(kMaxLength_m);
  if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = static_cast<const urdf::Box&>(geometry);
    for (const double x : {box.dim.x, box.dim.y, box.dim.z}) Checked(x, length, place, "box size");
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    Checked(cylinder.radius, length, place, "cylinder radius");
    Checked(cylinder.length, length, place, "cylinder length");
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    Checked(static_cast<const urdf::Sphere&>(geometry).radius, length, place, "sphere radius");
  }
}

Visual ReadVisual(const urdf::Visual& in, const std::string& place, const std::string& file,
                  Budget& left) {
  if (!in.geometry) Refuse(place, "visual: expected a <geometry>, found none");
  CheckShape(*in.geometry, place);
  Visual visual;
  visual.name = in.name;
  visual.X_LV = ToPose(in.origin, place, "visual");
  visual.mesh = ReadMesh(*in.geometry, place, file, left);
  if (in.material) {
    const urdf::Color& c = in.material->color;
    for (const float x : {c.r, c.g, c.b}) Checked(x, Between(0.0, 1.0), place, "colour");
    visual.rgb = {c.r, c.g, c.b};
  }
  return visual;
}

Collision ReadCollision(const urdf::Collision& in, const std::string& place,
                        const std::string& file, Budget& left) {
  if (!in.geometry) Refuse(place, "collision: expected a <geometry>, found none");
  CheckShape(*in.geometry, place);
  Collision collision;
  collision.name = in.name;
  collision.X_LG = ToPose(in.origin, place, "collision");
  const urdf::Geometry& geometry = *in.geometry;
  if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = static_cast<const urdf::Box&>(geometry);
    collision.shape = BoxShape{{box.dim.x, box.dim.y, box.dim.z}};
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    collision.shape = CylinderShape{cylinder.radius, cylinder.length};
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    collision.shape = SphereShape{static_cast<const urdf::Sphere&>(geometry).radius};
  } else {
    collision.shape = HullShape{ReadMesh(geometry, place, file, left)->vertices};
  }
  return collision;
}

void Spend(std::size_t corners, const std::string& place, Budget& left) {
  if (left.parts == 0) Refuse(place, "more than 2000 visuals and collisions in one file");
  if (corners > left.corners) Refuse(place, "more than 3 million mesh vertices in one file");
  --left.parts;
  left.corners -= corners;
}

LinkModel ReadLink(const urdf::Link& in, const std::string& place, const std::string& file,
                   Budget& left) {
  constexpr std::size_t kMaxParts = 256;
  if (in.visual_array.size() > kMaxParts || in.collision_array.size() > kMaxParts) {
    Refuse(place, "more than 256 visuals or collisions in one link");
  }
  LinkModel link;
  link.name = in.name;
  if (in.inertial) ReadInertial(*in.inertial, place, link);
  for (const auto& visual : in.visual_array) {
    if (!visual) continue;
    link.visuals.push_back(ReadVisual(*visual, place, file, left));
    Spend(link.visuals.back().mesh->vertices.size(), place, left);
  }
  for (const auto& collision : in.collision_array) {
    if (!collision) continue;
    link.collisions.push_back(ReadCollision(*collision, place, file, left));
    const auto* hull = std::get_if<HullShape>(&link.collisions.back().shape);
    Spend(hull == nullptr ? 0 : hull->points.size(), place, left);
  }
  return link;
}

std::string TypeName(int type) {
  switch (type) {
    case urdf::Joint::REVOLUTE:
      return "revolute";
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "unknown";
  }
}

UrdfJoint ReadJoint(const urdf::Joint& in, const std::string& place) {
  UrdfJoint joint;
  joint.name = in.name;
  joint.parent = in.parent_link_name;
  joint.child = in.child_link_name;
  joint.type = TypeName(in.type);
  joint.place = place;
  joint.X_PJ = ToPose(in.parent_to_joint_origin_transform, place, "joint");
  joint.axis_J = ToVector(in.axis, 1e3, place, "axis");
  if (joint.type != "fixed" && joint.type != "floating") {
    if (!(joint.axis_J.norm() > 1e-6)) Refuse(place, "axis: expected a direction, found 0 0 0");
    joint.axis_J.normalize();
  }
  if (in.limits) {
    joint.lower_rad = Checked(in.limits->lower, Between(-1e3, 1e3), place, "lower limit");
    joint.upper_rad =
        Checked(in.limits->upper, Between(joint.lower_rad, 1e3), place, "upper limit");
  }
  return joint;
}

/// Catches the messages of liburdfdom, as long as it lives.
class Complaints : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) text_ += "; " + text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

urdf::ModelInterfaceSharedPtr Parse(const std::string& text, const std::string& file) {
  const Complaints complaints;
  try {
    auto model = urdf::parseURDF(text);
    // After an error it continues without the faulty part.
    if (model && complaints.text().empty()) return model;
  } catch (const std::exception& error) {
    Refuse(file, std::string("not a usable URDF: ") + error.what());
  }
  Refuse(file, "not a usable URDF: liburdfdom refuses it" + complaints.text());
}

}  // namespace

const LinkModel& UrdfModel::Link(const std::string& link_name) const {
  for (const LinkModel& link : links) {
    if (link.name == link_name) return link;
  }
  Refuse(file, "expected a link named '" + link_name + "', found none");
}

const std::string& UrdfModel::PlaceOf(const std::string& link_name) const {
  return place[static_cast<std::size_t>(&Link(link_name) - links.data())];
}

const UrdfJoint& UrdfModel::Joint(const std::string& joint_name) const {
  for (const UrdfJoint& joint : joints) {
    if (joint.name == joint_name) return joint;
  }
  Refuse(file, "expected a joint named '" + joint_name + "', found none");
}

UrdfModel LoadUrdf(const std::string& file, MeshStore* meshes) {
  const std::string text = ReadText(file);
  const UrdfText checked = CheckUrdfXml(text, file);
  const auto place_of = [&](const std::string& element, const std::string& name) {
    const auto at = checked.places.find(element + " " + name);
    return (at == checked.places.end() ? file : at->second) + ": " + element + " '" + name + "'";
  };
  const urdf::ModelInterfaceSharedPtr parsed = Parse(text, file);
  UrdfModel model;
  model.name = parsed->getName();
  model.file = file;
  model.left_out = checked.left_out;
  model.root = parsed->getRoot() ? parsed->getRoot()->name : "";
  Budget left{.store = meshes};
  for (const auto& [name, link] : parsed->links_) {
    model.place.push_back(place_of("link", name));
    model.links.push_back(ReadLink(*link, model.place.back(), file, left));
  }
  for (const auto& [name, joint] : parsed->joints_) {
    model.joints.push_back(ReadJoint(*joint, place_of("joint", name)));
  }
  return model;
}

}  // namespace dockyard
