#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/plan/campaign_schema.h"
#include "sim/scenario/scenario_schema.h"

namespace dockyard {
namespace {

constexpr const char* kSchemaHelp =
    R"(Print the JSON Schema of a scenario or a campaign, for editors.

Examples:
  dockyard schema scenario >out/scenario.schema.json
  dockyard schema campaign >out/campaign.schema.json

With it an editor completes and checks a file. The schema (draft 2020-12) has each key's type,
range, words, default and meaning. An editor with the YAML language server reads it if the first
line of a file names it, relative to the file:

  # yaml-language-server: $schema=../out/scenario.schema.json

A schema sees one file: `dockyard check` also reads the models, and values that depend on others.)";

int PrintSchema(const std::string& of, const std::vector<System>& systems) {
  const std::vector<KnownSystem> known = KnownSystems(systems);
  std::vector<SystemKeys> with_keys;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    with_keys.push_back({known[i], systems[i].keys});
  }
  const Json schema =
      of == "scenario" ? SchemaDocument("A scenario of Dockyard", ScenarioSchema(with_keys, true))
                       : SchemaDocument("A campaign of Dockyard", CampaignSchema(with_keys));
  std::printf("%s\n", schema.dump(1).c_str());
  return kExitDone;
}

}  // namespace

void AddSchemaCommand(CLI::App& app, Invocation& call) {
  auto of = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("schema", kSchemaHelp);
  command->add_option("KIND", *of, "of which file")
      ->required()
      ->check(CLI::IsMember({"scenario", "campaign"}));
  command->callback([of, &call] { call.exit_code = PrintSchema(*of, call.systems); });
}

}  // namespace dockyard
