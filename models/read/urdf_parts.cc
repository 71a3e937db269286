#include "models/read/urdf_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/convex_pieces.h"
#include "models/read/urdf_inertia.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxParts = 256;  // visuals of a link, and collisions
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

/// The children of that name, in their order.
std::vector<const TiXmlElement*> ChildrenOf(const TiXmlElement& element, const char* tag) {
  std::vector<const TiXmlElement*> children;
  for (const TiXmlElement* e = element.FirstChildElement(tag); e; e = e->NextSiblingElement(tag)) {
    children.push_back(e);
  }
  return children;
}

bool HasNeitherMassNorMoments(const urdf::Inertial& in) {
  for (const double x : {in.mass, in.ixx, in.ixy, in.ixz, in.iyy, in.iyz, in.izz}) {
    if (x != 0.0) return false;
  }
  return true;
}

}  // namespace

UrdfParts::UrdfParts(const std::string& file, const UrdfOptions& options, UrdfFaults& faults)
    : faults_(faults), addresses_(file, options.packages), store_(options.meshes) {}

void UrdfParts::ReadInertial(const urdf::Inertial& in, const TiXmlElement& element,
                             const std::string& place, LinkModel& link) {
  if (HasNeitherMassNorMoments(in)) return;  // as exporters write a frame
  if (in.mass == 0.0)
    Refuse(place, "mass: expected a number > 0, or 0 with moments of 0, found '0'");
  const double mass_kg = Checked(in.mass, Positive(kMaxMass_kg), place, "mass");
  const Pose3 X_LI = ToPose(in.origin, place, "inertial");
  const InertiaCheck check = CheckInertia(*element.FirstChildElement("inertia"));
  if (!check.fault.empty()) Refuse(place, check.fault);
  if (!check.warning.empty()) warnings_.push_back(place + ": " + check.warning);
  Eigen::Matrix3d I;
  I << in.ixx, in.ixy, in.ixz, in.ixy, in.iyy, in.iyz, in.ixz, in.iyz, in.izz;
  link.mass_kg = mass_kg;
  link.p_LoCom_L = X_LI.p;
  link.I_LCom_L = X_LI.R * I * X_LI.R.transpose();
}

/// A cylinder, box or sphere as a mesh; a mesh from its file.
UrdfParts::Mesh UrdfParts::ReadMesh(const urdf::Geometry& geometry, const std::string& place) {
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
  const auto path = addresses_.Resolve(mesh.filename, place + ": mesh filename");
  Mesh& loaded = meshes_[path.string()];
  if (!loaded) loaded = LoadMesh(path, store_);
  if (scale == Eigen::Vector3d::Ones()) return loaded;
  return std::make_shared<const TriangleMesh>(Scaled(*loaded, scale));
}

Visual UrdfParts::ReadVisual(const urdf::Visual& in, const std::string& place) {
  if (!in.geometry) Refuse(place, "visual: expected a <geometry>, found none");
  CheckShape(*in.geometry, place);
  Visual visual;
  visual.name = in.name;
  visual.X_LV = ToPose(in.origin, place, "visual");
  visual.mesh = ReadMesh(*in.geometry, place);
  if (in.material) {
    const urdf::Color& c = in.material->color;
    visual.rgb = {c.r, c.g, c.b};
  }
  return visual;
}

void UrdfParts::AddHulls(const Collision& collision, const urdf::Mesh& named,
                         const std::string& place, std::vector<Collision>& collisions) {
  const Mesh read = ReadMesh(named, place);
  const TriangleMesh& mesh = *read;
  const auto add = [&](const std::vector<Eigen::Vector3d>& corners) {
    collisions.push_back(collision);
    collisions.back().shape = HullShape{corners};
    Spend(corners.size(), place);
  };
  if (IsFlat(mesh.vertices)) Refuse(place, "collision: expected a mesh with a thickness");
  if (IsConvex(mesh)) return add(mesh.vertices);
  if (mesh.triangles.size() <= kMostPartedTriangles) {
    auto& pieces = pieces_[named.filename + " " + NumberText(named.scale.x) + " " +
                           NumberText(named.scale.y) + " " + NumberText(named.scale.z)];
    if (pieces.empty()) pieces = ConvexPieces(mesh);
    for (const std::vector<Eigen::Vector3d>& piece : pieces) add(piece);
    if (pieces.size() > 1) return;
  } else {
    add(mesh.vertices);
  }
  warnings_.push_back(place + ": collision: a mesh with hollows and " +
                      std::to_string(mesh.triangles.size()) +
                      " triangles: its convex hull counts; its hollows do if it is a closed "
                      "surface of at most " +
                      std::to_string(kMostPartedTriangles) + " triangles");
}

void UrdfParts::ReadCollision(const urdf::Collision& in, const std::string& place,
                              std::vector<Collision>& collisions) {
  if (!in.geometry) Refuse(place, "collision: expected a <geometry>, found none");
  CheckShape(*in.geometry, place);
  Collision collision;
  collision.name = in.name;
  collision.X_LG = ToPose(in.origin, place, "collision");
  const urdf::Geometry& geometry = *in.geometry;
  if (geometry.type == urdf::Geometry::MESH) {
    return AddHulls(collision, static_cast<const urdf::Mesh&>(geometry), place, collisions);
  }
  if (geometry.type == urdf::Geometry::BOX) {
    const auto& box = static_cast<const urdf::Box&>(geometry);
    collision.shape = BoxShape{{box.dim.x, box.dim.y, box.dim.z}};
  } else if (geometry.type == urdf::Geometry::CYLINDER) {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    collision.shape = CylinderShape{cylinder.radius, cylinder.length};
  } else {
    collision.shape = SphereShape{static_cast<const urdf::Sphere&>(geometry).radius};
  }
  collisions.push_back(collision);
  Spend(0, place);
}

void UrdfParts::Spend(std::size_t corners, const std::string& place) {
  if (parts_left_ == 0) Refuse(place, "more than 2000 visuals and collisions in one file");
  if (corners > corners_left_) Refuse(place, "more than 3 million mesh vertices in one file");
  --parts_left_;
  corners_left_ -= corners;
}

LinkModel UrdfParts::ReadLink(const urdf::Link& in, const TiXmlElement& element) {
  const std::string of_link = ": link '" + in.name + "'";
  const auto visuals = ChildrenOf(element, "visual"), collisions = ChildrenOf(element, "collision");
  if (visuals.size() > kMaxParts || collisions.size() > kMaxParts) {
    Refuse(faults_.PlaceOf(element) + of_link, "more than 256 visuals or collisions in one link");
  }
  LinkModel link;
  link.name = in.name;
  const auto read = [&](const TiXmlElement& part, const auto& of_part) {
    faults_.Catch(part, [&] { of_part(faults_.PlaceOf(part) + of_link); });
  };
  if (const TiXmlElement* e = element.FirstChildElement("inertial"); e != nullptr && in.inertial) {
    read(*e, [&](const std::string& place) { ReadInertial(*in.inertial, *e, place, link); });
  }
  for (std::size_t i = 0; i < std::min(visuals.size(), in.visual_array.size()); ++i) {
    read(*visuals[i], [&](const std::string& place) {
      link.visuals.push_back(ReadVisual(*in.visual_array[i], place));
      Spend(link.visuals.back().mesh->vertices.size(), place);
    });
  }
  for (std::size_t i = 0; i < std::min(collisions.size(), in.collision_array.size()); ++i) {
    read(*collisions[i], [&](const std::string& place) {
      ReadCollision(*in.collision_array[i], place, link.collisions);
    });
  }
  return link;
}

UrdfJoint UrdfParts::ReadJoint(const urdf::Joint& in, const TiXmlElement& element) const {
  const std::string place = faults_.PlaceOf(element) + ": joint '" + in.name + "'";
  UrdfJoint joint;
  joint.name = in.name;
  joint.parent = in.parent_link_name;
  joint.child = in.child_link_name;
  joint.type = element.Attribute("type");  // a known one: CheckUrdfXml
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
  if (in.dynamics) {
    joint.damping_nms_per_rad = Checked(in.dynamics->damping, NonNegative(1e6), place, "damping");
    joint.friction_nm = Checked(in.dynamics->friction, NonNegative(1e6), place, "friction");
  }
  if (in.mimic) {
    joint.mimics = in.mimic->joint_name;
    joint.mimic_ratio = Checked(in.mimic->multiplier, Between(-1e4, 1e4), place, "multiplier");
    joint.mimic_offset_rad = Checked(in.mimic->offset, Between(-1e3, 1e3), place, "offset");
  }
  return joint;
}

}  // namespace dockyard
