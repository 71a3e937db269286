#include <algorithm>
#include <cstdio>
#include <memory>

#include "sim/app/commands.h"
#include "sim/app/doctor.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"
#include "sim/base/json.h"
#include "sim/run/renderer.h"

namespace dockyard {
namespace {

constexpr const char* kDoctorHelp =
    R"(Say what this computer has for runs, and whether they equal those of others.

Examples:
  dockyard doctor
  dockyard doctor --json

Draws a small image, and tries a lock in the working folder. Runs are equal bit for bit between
computers whose lines program, mathematics and gl_image are equal. Exit code 10: something that a
run needs is missing.)";

std::vector<Finding> Examine() {
  std::vector<Finding> findings = ExamineFacts(Environment());
  const std::vector<Finding> drawing = ExamineFacts(RendererFacts());
  const std::vector<Finding> machine =
      ExamineMachine(UsableProcessors(), UsableMemory(), FreeDiskMib("."), LockFault("."),
                     FreeDiskMib("/dev/shm"));
  for (const auto* part : {&drawing, &machine}) {
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
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"name", finding.name},
                    {"value", finding.value},
                    {"health", Name(finding.health)},
                    {"advice", finding.advice}});
  }
  const Json answer{{"findings", list}, {"warnings", warnings}};
  std::printf("%s\n", answer.dump(1).c_str());
}

int Doctor(bool json, const std::vector<std::string>& warnings) {
  const std::vector<Finding> findings = Examine();
  json ? PrintJson(findings, warnings) : PrintText(findings);
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
  command->callback([json, &call] { call.exit_code = Doctor(*json, call.warnings); });
}

}  // namespace dockyard
