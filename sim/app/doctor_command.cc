#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "sim/app/commands.h"
#include "sim/app/doctor.h"
#include "sim/app/examples.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"
#include "sim/base/json.h"
#include "sim/plant/renderer.h"
#include "sim/run/start_images.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

constexpr const char* kDoctorHelp =
    R"(Say what this computer has for runs, and whether they equal those of others.

Examples:
  dockyard doctor
  dockyard doctor --json

Draws what each system's cameras see at a start, and tries a lock in the working folder. A system's
runs are equal bit for bit between computers whose lines program, mathematics and image_SYSTEM are
equal. Exit code 10: something that a run needs is missing.

--json prints {findings: [{name, value, health, advice}], images: {SYSTEM: FINGERPRINT}, warnings}.)";

/// Of the systems that have a scenario and cameras.
std::vector<Finding> ExamineAllImages(const std::vector<System>& systems) {
  std::vector<Finding> findings;
  for (const System& system : systems) {
    if (system.example_files.scenario.empty()) continue;
    const std::filesystem::path file = FindExample(system.example_files.scenario);
    const std::string value =
        file.empty() ? kNoScenario
                     : StartImages(system, LoadScenario(file, {}, KnownSystems(systems)));
    if (!value.empty())
      findings.push_back(ExamineImages(system.name, value, system.example_files.start_images));
  }
  return findings;
}

std::vector<Finding> Examine(const std::vector<System>& systems) {
  std::vector<Finding> findings = ExamineFacts(Environment());
  const std::vector<Finding> drawing = ExamineFacts(RendererFacts());
  const std::vector<Finding> images = ExamineAllImages(systems);
  const std::vector<Finding> machine =
      ExamineMachine(UsableProcessors(), UsableMemory(), FreeDiskMib("."), LockFault("."),
                     FreeDiskMib("/dev/shm"));
  for (const auto* part : {&drawing, &images, &machine}) {
    findings.insert(findings.end(), part->begin(), part->end());
  }
  return findings;
}

void PrintText(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    std::printf("%-8s %-12s %s\n", Name(finding.health).c_str(), finding.name.c_str(),
                finding.value.c_str());
    if (!finding.advice.empty()) std::printf("%21s %s\n", "", finding.advice.c_str());
  }
}

void PrintJson(const std::vector<Finding>& findings, const std::vector<std::string>& warnings) {
  Json list = Json::array(), images = Json::object();
  for (const Finding& finding : findings) {
    list.push_back({{"name", finding.name},
                    {"value", finding.value},
                    {"health", Name(finding.health)},
                    {"advice", finding.advice}});
    if (finding.name.starts_with(kImages)) {
      images[finding.name.substr(std::strlen(kImages))] = finding.value;
    }
  }
  const Json answer{{"findings", list}, {"images", images}, {"warnings", warnings}};
  std::printf("%s\n", answer.dump(1).c_str());
}

int Doctor(bool json, const Invocation& call) {
  const std::vector<Finding> findings = Examine(call.systems);
  json ? PrintJson(findings, call.warnings) : PrintText(findings);
  const bool missing = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.health == Health::kMissing;
  });
  return missing ? kExitIncomplete : kExitDone;
}

}  // namespace

void AddDoctorCommand(CLI::App& app, Invocation& call) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("doctor", kDoctorHelp);
  command->add_flag("--json", *json, "the findings as JSON");
  command->callback([json, &call] { call.exit_code = Doctor(*json, call); });
}

}  // namespace dockyard
