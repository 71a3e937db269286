#include "models/read/load_joints.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/load_contact.h"
#include "models/read/load_motor.h"
#include "models/read/urdf_weld.h"

namespace dockyard {
namespace {

// A tree of the simulation has room for these and the links of any system.
constexpr std::size_t kMostJoints = 20;

void VisitJoint(Keys& keys, JointFile& joint) {
  const auto unset = [](const char* name, const char* unit, const char* says) {
    return Key(name, unit, says, Presence::kUnset);
  };
  keys.Text({"name", "", "of the URDF's joint", Presence::kRequired}, joint.name);
  keys.Degrees(unset("start_deg", "deg", "angle at the start"), joint.start_rad,
               Between(-3600.0, 3600.0));
  keys.Number(unset("start_m", "m", "travel of a slide at the start"), joint.start_m,
              Between(-100.0, 100.0));
  keys.Mapping(Unset("stop"), [&](Keys& in) {
    VisitStop(in, joint.stop, Presence::kUnset);
    VisitSlideStop(in, joint.slide_stop, Presence::kUnset);
  });
  keys.Mapping(Unset("spring"), [&](Keys& in) {
    in.Number(unset("stiffness_nm_per_rad", "N m/rad", "of a spring at the joint"),
              joint.spring_nm_per_rad, Positive(1e8));
    in.Degrees(unset("rest_deg", "deg", "at which it is free"), joint.rest_rad,
               Between(-3600.0, 3600.0));
    in.Number(unset("stiffness_n_per_m", "N/m", "of a slide's spring"), joint.spring_n_per_m,
              Positive(1e9));
    in.Number(unset("rest_m", "m", "at which that is free"), joint.rest_m, Between(-100.0, 100.0));
  });
  keys.Mapping(Unset("motor"), [&](Keys& in) {
    VisitMotor(in, joint.motor ? *joint.motor : joint.motor.emplace());
  });
  keys.Degrees(unset("rate_deg_s", "deg/s", "at which its motor runs to and fro"), joint.rate_rad_s,
               Between(-3600.0, 3600.0));
  keys.Number(unset("rate_m_s", "m/s", "the same of a slide"), joint.rate_m_s,
              Between(-10.0, 10.0));
  keys.Number(unset("lead_m_per_turn", "m", "travel of a slide for a turn of its motor's screw"),
              joint.lead_m_per_turn, Positive(10.0));
}

void VisitPin(Keys& keys, PinFile& file) {
  keys.Text({"link", "", "one of the two", Presence::kRequired}, file.link);
  keys.Text({"to", "", "the other", Presence::kRequired}, file.to);
  keys.Vector3({"at_m", "m", "in the frame of the first", Presence::kRequired}, file.pin.p_A,
               Between(-100.0, 100.0));
  keys.Number({"stiffness_n_per_m", "N/m", "of the pin in its bore"}, file.pin.stiffness_n_per_m,
              Positive(1e10));
  keys.Number({"damping_ns_per_m", "N s/m", "of the same"}, file.pin.damping_ns_per_m,
              NonNegative(1e8));
}

bool Has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Of a link by its name; -1: none.
int NumberOf(const OwnLinks& own, const JointedLinks& taken, const std::string& link) {
  const auto of_own = std::find(own.links.begin(), own.links.end(), link);
  if (of_own != own.links.end()) return static_cast<int>(of_own - own.links.begin());
  for (std::size_t i = 0; i < taken.links.size(); ++i) {
    if (taken.links[i].link.name == link) return static_cast<int>(own.links.size() + i);
  }
  return -1;
}

/// Takes the joints of a tree, each after its carrier.
class Taking {
 public:
  Taking(const UrdfModel& welded, const OwnLinks& own) : urdf_(welded), own_(own) {}

  JointedLinks Run() {
    std::vector<const UrdfJoint*> open;
    for (const UrdfJoint& joint : urdf_.joints) {
      if (!Has(own_.joints, joint.name)) open.push_back(&joint);
    }
    // Each pass takes the joints whose carriers are there; URDF files are trees.
    while (!open.empty()) {
      std::erase_if(open, [&](const UrdfJoint* joint) {
        const bool ready = NumberOf(joint->parent) >= 0;
        if (ready) Take(*joint);
        return ready;
      });
    }
    for (const UrdfJoint& joint : urdf_.joints) TakeRatio(joint, {});
    return std::move(taken_);
  }

 private:
  int NumberOf(const std::string& link) const { return dockyard::NumberOf(own_, taken_, link); }

  void Take(const UrdfJoint& joint) {
    if (joint.type != "continuous" && joint.type != "revolute" && joint.type != "prismatic") {
      throw ConfigError(joint.place + ": a " + joint.type + " joint from '" + joint.parent +
                        "' to '" + joint.child +
                        "' is not simulated, only continuous, revolute, prismatic and fixed ones "
                        "are");
    }
    JointedLink& each = taken_.links.emplace_back();
    each.carrier = NumberOf(joint.parent);
    each.link = RequireInertial(urdf_, joint.child);
    each.joint = joint.name;
    each.X_PL = joint.X_PJ;
    each.axis_L = joint.axis_J;
    each.slides = joint.type == "prismatic";
    if (each.slides) each.stop = kSlideStop;
    each.damping_nms_per_rad = joint.damping_nms_per_rad;
    each.friction_nm = joint.friction_nm;
    if (joint.type == "continuous") return;
    each.low_rad = joint.lower_rad;
    each.high_rad = joint.upper_rad;
    if (each.low_rad < each.high_rad) return;
    throw ConfigError(joint.place + ": expected a <limit> with upper above lower");
  }

  /// After the ratio of the joint that it follows. followers: that wait for this one.
  void TakeRatio(const UrdfJoint& joint, std::vector<std::string> followers) {
    if (joint.mimics.empty() || Has(with_ratio_, joint.name)) return;
    if (Has(followers, joint.name)) {
      throw ConfigError(joint.place + ": <mimic>: joints that follow each other in a circle");
    }
    const auto other =
        std::find_if(urdf_.joints.begin(), urdf_.joints.end(),
                     [&](const UrdfJoint& each) { return each.name == joint.mimics; });
    if (other == urdf_.joints.end() || other->name == joint.name) {
      throw ConfigError(joint.place +
                        ": <mimic>: expected the name of another joint that moves, "
                        "found '" +
                        joint.mimics + "'");
    }
    followers.push_back(joint.name);
    TakeRatio(*other, followers);
    taken_.ratios.push_back(
        {NumberOf(joint.child), NumberOf(other->child), joint.mimic_ratio, joint.mimic_offset_rad});
    with_ratio_.push_back(joint.name);
  }

  const UrdfModel& urdf_;
  const OwnLinks& own_;
  JointedLinks taken_;
  std::vector<std::string> with_ratio_;  // joints
};

/// Refuses keys of one item of a list.
class ItemReader {
 public:
  ItemReader(const YamlReader& in, const char* list, std::size_t i)
      : item_(in.List(list, 0, 1000).items[i]), path_(YamlReader::PathOf(in.PathOf(list), i)) {}

  [[noreturn]] void Refuse(const std::string& expected) const {
    throw ConfigError(item_.place.Text() + ": " + path_ + ": expected " + expected);
  }

 private:
  const YamlNode& item_;
  std::string path_;
};

void Put(double value, double& variable) {
  if (!std::isnan(value)) variable = value;
}

void TakeMotor(const ItemReader& in, const JointFile& file, JointedLink& link) {
  const double rate = link.slides ? file.rate_m_s : file.rate_rad_s;
  if (!file.motor) {
    if (!std::isnan(rate)) in.Refuse("a motor with the rate");
    if (!std::isnan(file.lead_m_per_turn)) in.Refuse("a motor with lead_m_per_turn");
    return;
  }
  if (link.slides == std::isnan(file.lead_m_per_turn)) {
    in.Refuse(link.slides ? "lead_m_per_turn of the slide's motor"
                          : "no lead_m_per_turn: the joint turns");
  }
  JointMotor& motor = link.motor.emplace();
  motor.model = *file.motor;
  Put(rate, motor.rate_rad_s);
  Put(file.lead_m_per_turn, motor.lead_m_per_turn);
  const double shaft_rad_s =
      link.slides ? motor.rate_rad_s * 2.0 * kPi / motor.lead_m_per_turn : motor.rate_rad_s;
  if (std::abs(shaft_rad_s) > motor.model.max_speed_rad_s) {
    in.Refuse("a rate of no more than motor.max_speed_rad_s");
  }
}

void TakeKeys(const ItemReader& in, const JointFile& file, JointedLink& link) {
  const auto any = [](std::initializer_list<double> keys) {
    return std::any_of(keys.begin(), keys.end(), [](double key) { return !std::isnan(key); });
  };
  const bool of_slide =
      any({file.start_m, file.slide_stop.stiffness_nm_per_rad, file.slide_stop.damping_nms_per_rad,
           file.spring_n_per_m, file.rest_m, file.rate_m_s});
  const bool of_turn =
      any({file.start_rad, file.stop.stiffness_nm_per_rad, file.stop.damping_nms_per_rad,
           file.spring_nm_per_rad, file.rest_rad, file.rate_rad_s});
  if (link.slides ? of_turn : of_slide) {
    in.Refuse(link.slides ? "keys of a slide (start_m, rest_m, n_per_m): the joint slides"
                          : "keys of a turn (start_deg, rest_deg, nm_per_rad): the joint turns");
  }
  Put(link.slides ? file.start_m : file.start_rad, link.start_rad);
  const JointStop& stop = link.slides ? file.slide_stop : file.stop;
  Put(stop.stiffness_nm_per_rad, link.stop.stiffness_nm_per_rad);
  Put(stop.damping_nms_per_rad, link.stop.damping_nms_per_rad);
  Put(link.slides ? file.spring_n_per_m : file.spring_nm_per_rad, link.spring_nm_per_rad);
  Put(link.slides ? file.rest_m : file.rest_rad, link.rest_rad);
  if (!std::isfinite(link.low_rad) && any({stop.stiffness_nm_per_rad, stop.damping_nms_per_rad})) {
    in.Refuse("no stop: the joint is continuous");
  }
  if (any({file.rest_rad, file.rest_m}) && link.spring_nm_per_rad == 0.0) {
    in.Refuse("the spring's stiffness with where it is free");
  }
  TakeMotor(in, file, link);
}

bool Follows(const JointedLinks& taken, int link) {
  return std::any_of(taken.ratios.begin(), taken.ratios.end(),
                     [&](const JointRatio& ratio) { return ratio.link == link; });
}

void TakeListed(const YamlReader& in, const OwnLinks& own, const JointsFile& file,
                JointedLinks& taken) {
  std::vector<std::string> listed;
  for (std::size_t i = 0; i < file.joints.size(); ++i) {
    const JointFile& joint = file.joints[i];
    const ItemReader item(in, "joints", i);
    const auto named = [&](const JointedLink& link) { return link.joint == joint.name; };
    const auto link = std::find_if(taken.links.begin(), taken.links.end(), named);
    if (link == taken.links.end()) {
      item.Refuse("the name of a joint of the URDF file that moves a further link, found '" +
                  joint.name + "'");
    }
    if (Has(listed, joint.name)) item.Refuse("each joint once, found '" + joint.name + "' again");
    listed.push_back(joint.name);
    TakeKeys(item, joint, *link);
    const auto number =
        static_cast<int>(own.links.size()) + static_cast<int>(link - taken.links.begin());
    if (Follows(taken, number) && !(std::isnan(joint.start_rad) && std::isnan(joint.start_m))) {
      item.Refuse("no start of a joint that follows another");
    }
  }
}

void TakePins(const YamlReader& in, const OwnLinks& own, const JointsFile& file,
              JointedLinks& taken) {
  const auto number_of = [&](const ItemReader& item, const std::string& name) {
    const int link = NumberOf(own, taken, name);
    if (link < 0) item.Refuse("the name of a link that moves, found '" + name + "'");
    return link;
  };
  const auto own_count = static_cast<int>(own.links.size());
  for (std::size_t i = 0; i < file.pins.size(); ++i) {
    const ItemReader item(in, "pins", i);
    LinkPin pin = file.pins[i].pin;
    pin.a = number_of(item, file.pins[i].link);
    pin.b = number_of(item, file.pins[i].to);
    if (pin.a == pin.b) item.Refuse("two links");
    if (pin.a < own_count && pin.b < own_count) item.Refuse("a pin of at least one further link");
    const auto same = [&](const LinkPin& other) {
      return other.a == pin.a && other.b == pin.b && other.p_A == pin.p_A;
    };
    if (std::any_of(taken.pins.begin(), taken.pins.end(), same)) item.Refuse("each pin once");
    taken.pins.push_back(pin);
  }
}

// A follower starts where others put it, which the run knows.
void CheckStarts(const UrdfModel& welded, const OwnLinks& own, const JointedLinks& taken) {
  for (std::size_t i = 0; i < taken.links.size(); ++i) {
    const JointedLink& each = taken.links[i];
    if (Follows(taken, static_cast<int>(own.links.size() + i))) continue;
    if (each.start_rad >= each.low_rad && each.start_rad <= each.high_rad) continue;
    throw ConfigError(welded.Joint(each.joint).place +
                      ": expected a start within its limits, found " +
                      NumberText(each.slides ? std::round(1e5 * each.start_rad) / 1e5
                                             : std::round(1e3 * Degrees(each.start_rad)) / 1e3) +
                      (each.slides ? " m" : " deg"));
  }
}

}  // namespace

void VisitJoints(Keys& keys, JointsFile& file) {
  keys.Items({"joints", "", "what the URDF has no word for of joints", Presence::kUnset},
             file.joints, 0, kMostJoints, VisitJoint);
  keys.Items({"pins", "", "ball joints that close loops", Presence::kUnset}, file.pins, 0,
             kMostJoints, VisitPin);
  keys.Mapping(Optional("link_contact"),
               [&](Keys& in) { VisitContact(in, file.contact, Presence::kDefault); });
}

JointedLinks TakeJointedLinks(const YamlReader& in, const UrdfModel& welded, const OwnLinks& own,
                              const JointsFile& file) {
  for (const std::string& joint : own.joints) RequirePlain(welded.Joint(joint));
  Taking taking(welded, own);
  JointedLinks taken = taking.Run();
  taken.contact = file.contact;
  if (taken.links.size() > kMostJoints) {
    throw ConfigError(welded.file + ": expected at most " + std::to_string(kMostJoints) +
                      " joints that move in addition to the system's own");
  }
  TakeListed(in, own, file, taken);
  TakePins(in, own, file, taken);
  CheckStarts(welded, own, taken);
  return taken;
}

}  // namespace dockyard
