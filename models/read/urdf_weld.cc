#include "models/read/urdf_weld.h"

#include <algorithm>
#include <map>

#include "controller/base/number_text.h"
#include "controller/geometry/decompositions.h"
#include "models/read/config_error.h"

namespace dockyard {
namespace {

/// Where a link is carried: its carrier's name, and its own frame F in the carrier's frame C.
struct Carried {
  std::string by;
  Pose3 X_CF;
};

using FixedJoints = std::map<std::string, const UrdfJoint*>;  // by child link

FixedJoints FindFixedJoints(const UrdfModel& model) {
  FixedJoints fixed;
  for (const UrdfJoint& joint : model.joints) {
    if (joint.type == "fixed") fixed[joint.child] = &joint;
  }
  return fixed;
}

Carried Carry(const FixedJoints& fixed, const std::string& link) {
  Carried carried{link, Pose3()};
  for (auto at = fixed.find(link); at != fixed.end(); at = fixed.find(carried.by)) {
    carried.X_CF = at->second->X_PJ * carried.X_CF;
    carried.by = at->second->parent;
  }
  return carried;
}

/// Inertia about a point at `p` from the centre of mass (Huygens and Steiner).
Eigen::Matrix3d Shifted(const Eigen::Matrix3d& I_Com, double mass_kg, const Eigen::Vector3d& p) {
  return I_Com + mass_kg * (p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose());
}

void Weld(const LinkModel& part, const Pose3& X_CF, LinkModel& carrier) {
  if (part.mass_kg > 0.0) {
    const Eigen::Vector3d p_part = X_CF * part.p_LoCom_L;
    const Eigen::Matrix3d I_part = X_CF.R * part.I_LCom_L * X_CF.R.transpose();
    const double mass_kg = carrier.mass_kg + part.mass_kg;
    const Eigen::Vector3d com =
        (carrier.mass_kg * carrier.p_LoCom_L + part.mass_kg * p_part) / mass_kg;
    carrier.I_LCom_L = Shifted(carrier.I_LCom_L, carrier.mass_kg, carrier.p_LoCom_L - com) +
                       Shifted(I_part, part.mass_kg, p_part - com);
    carrier.p_LoCom_L = com;
    carrier.mass_kg = mass_kg;
  }
  for (Visual visual : part.visuals) {
    visual.X_LV = X_CF * visual.X_LV;
    carrier.visuals.push_back(std::move(visual));
  }
  for (Collision collision : part.collisions) {
    collision.X_LG = X_CF * collision.X_LG;
    carrier.collisions.push_back(std::move(collision));
  }
}

}  // namespace

std::string CarrierOf(const UrdfModel& model, const std::string& link) {
  return Carry(FindFixedJoints(model), link).by;
}

Pose3 FrameInCarrier(const UrdfModel& model, const std::string& link) {
  return Carry(FindFixedJoints(model), link).X_CF;
}

UrdfModel WeldFixedLinks(const UrdfModel& model) {
  const FixedJoints fixed = FindFixedJoints(model);
  UrdfModel welded = model;
  welded.links.clear();
  welded.place.clear();
  welded.joints.clear();
  std::map<std::string, std::size_t> index;  // in welded.links
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (fixed.count(model.links[i].name) > 0) continue;
    index[model.links[i].name] = welded.links.size();
    welded.links.push_back(model.links[i]);
    welded.place.push_back(model.place[i]);
  }
  for (const LinkModel& link : model.links) {
    if (fixed.count(link.name) == 0) continue;
    const Carried carried = Carry(fixed, link.name);
    Weld(link, carried.X_CF, welded.links[index.at(carried.by)]);
  }
  for (UrdfJoint joint : model.joints) {
    if (joint.type == "fixed") continue;
    const Carried carried = Carry(fixed, joint.parent);
    if (carried.by != joint.parent) {
      joint.X_PJ = carried.X_CF * joint.X_PJ;
      joint.parent = carried.by;
    }
    welded.joints.push_back(std::move(joint));
  }
  return welded;
}

const LinkModel& RequireInertial(const UrdfModel& welded, const std::string& name) {
  const LinkModel& link = welded.Link(name);
  if (!(link.mass_kg > 0.0)) {
    throw ConfigError(welded.PlaceOf(name) + ": expected an <inertial>, found none");
  }
  const Eigen::Vector3d moments = EigenOfSymmetric(link.I_LCom_L).values;
  if (moments[0] > 1e-9 * moments[2]) return link;
  throw ConfigError(welded.PlaceOf(name) +
                    ": inertia: a link that moves needs three principal moments > 0, found the "
                    "smallest " +
                    NumberText(moments[0]) + " kg m^2");
}

void RequirePlain(const UrdfJoint& joint) {
  if (joint.damping_nms_per_rad == 0.0 && joint.friction_nm == 0.0 && joint.mimics.empty()) return;
  throw ConfigError(joint.place +
                    ": expected neither damping, friction nor <mimic>: the robot's YAML file has "
                    "the motors' friction");
}

void RequireJoints(const UrdfModel& welded, const std::vector<std::string>& joints,
                   const std::string& simulated) {
  for (const UrdfJoint& joint : welded.joints) {
    if (std::find(joints.begin(), joints.end(), joint.name) != joints.end()) {
      RequirePlain(joint);
      continue;
    }
    throw ConfigError(joint.place + ": a " + joint.type + " joint from '" + joint.parent +
                      "' to '" + joint.child + "' is not simulated, only " + simulated +
                      " are, and what hangs on them by fixed joints");
  }
}

}  // namespace dockyard
