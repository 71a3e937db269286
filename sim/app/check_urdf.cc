#include "sim/app/check_urdf.h"

#include "models/read/load_model_yaml.h"
#include "models/read/mesh_size.h"
#include "models/read/text_file.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_path.h"
#include "sim/base/count_text.h"

namespace dockyard {
namespace {

/// Links that a joint moves and that have no mass, with what is welded to them.
void WarnOfMassless(const UrdfModel& model, std::vector<std::string>& warnings) {
  const UrdfModel welded = WeldFixedLinks(model);
  for (const UrdfJoint& joint : welded.joints) {
    if (welded.Link(joint.child).mass_kg > 0.0) continue;
    warnings.push_back(welded.PlaceOf(joint.child) + ": it has no mass, and the " + joint.type +
                       " joint '" + joint.name + "' moves it: a run refuses such a link");
  }
}

/// Warnings of what the reader takes and a user may not mean, each with its place.
std::vector<std::string> WarningsOf(const UrdfModel& model) {
  std::vector<std::string> warnings = model.warnings;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (const Visual& visual : model.links[i].visuals) {
      const std::string doubt = UnitDoubt(ExtentOf(*visual.mesh));
      if (!doubt.empty()) warnings.push_back(model.place[i] + ": visual: " + doubt);
    }
  }
  WarnOfMassless(model, warnings);
  for (const char* ignored : {"joint_properties", "surface", "contact", "contact_coefficients"}) {
    if (model.left_out.count(ignored) == 0) continue;
    warnings.push_back(model.file + ": <" + ignored +
                       "> is left out: friction and damping come from the robot's YAML file");
  }
  return warnings;
}

/// "2 <gazebo>, 1 <transmission>"
std::string LeftOutText(const UrdfModel& model) {
  std::string text;
  for (const auto& [element, count] : model.left_out) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " <" + element + ">";
  }
  return text;
}

/// The file that the value names, as the reader of the model resolves it; empty for another value.
std::string FileAt(const YamlNode* value) {
  if (value == nullptr || value->kind != YamlNode::Kind::kScalar) return "";
  const auto& written_in = value->place.source;
  return ResolveBeside(written_in ? *written_in : "", value->scalar).string();
}

}  // namespace

UrdfOptions UrdfCheckOptions(const PackageFolders& packages) {
  return {.meshes = nullptr, .packages = packages, .expand_xacro = true};
}

FileCheck CheckUrdf(const std::string& file, const PackageFolders& packages) {
  const UrdfModel model = LoadUrdf(file, UrdfCheckOptions(packages));
  double mass_kg = 0.0;
  for (const LinkModel& link : model.links) mass_kg += link.mass_kg;
  std::string summary = model.name + ": " + CountText(model.links.size(), "link") + ", " +
                        CountText(model.joints.size(), "joint") + ", " + NumberText(mass_kg) +
                        " kg";
  std::string welded;
  for (const LinkModel& link : model.links) {
    const std::string carrier = CarrierOf(model, link.name);
    if (carrier == link.name) continue;
    welded += (welded.empty() ? "; welded: " : ", ") + link.name + " into " + carrier;
  }
  const std::string left_out = LeftOutText(model);
  return {"urdf",
          summary + welded + (left_out.empty() ? "" : "; left out: " + left_out) +
              "; a run takes it only through a robot's or target's YAML file, with the links and "
              "joints of that system",
          WarningsOf(model), model.left_out};
}

const std::string& NamedUrdfs::UrdfOf(const std::string& yaml) {
  const auto [at, fresh] = by_model_.try_emplace(yaml);
  if (fresh) at->second = FileAt(LoadModelYaml(yaml).Find("urdf"));
  return at->second;
}

void NamedUrdfs::AddModel(const std::string& yaml) {
  const std::string& urdf = UrdfOf(yaml);
  if (!urdf.empty()) files_.insert(urdf);
}

void NamedUrdfs::AddScenario(const Scenario& scenario, const System& system) {
  const std::string own = system.name + ".";
  for (const ModelRoot& root : system.scenario.model_roots) {
    std::string model;
    if (root.file_key == "robot") {
      model = scenario.robot_file;
    } else if (root.file_key.starts_with(own)) {
      model = FileAt(FindPath(scenario.of_system, root.file_key.substr(own.size())));
    }
    if (model.empty()) continue;
    const std::string key = root.name + ".urdf";
    const std::string changed = FileAt(FindPath(scenario.changes, key)),
                      built = FileAt(FindPath(scenario.as_built, key));
    if (changed.empty()) {
      AddModel(model);
    } else {
      files_.insert(changed);
    }
    if (!built.empty()) files_.insert(built);
  }
}

FileCheck WithUrdfs(const NamedUrdfs& urdfs, FileCheck check) {
  for (const std::string& file : urdfs.files()) {
    const UrdfModel model = LoadUrdf(file);
    const std::vector<std::string> warnings = WarningsOf(model);
    check.warnings.insert(check.warnings.end(), warnings.begin(), warnings.end());
    if (model.left_out.empty()) continue;
    check.summary += "; left out of " + file + ": " + LeftOutText(model);
    for (const auto& [element, count] : model.left_out) check.left_out[element] += count;
  }
  return check;
}

}  // namespace dockyard
