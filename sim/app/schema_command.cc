#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "models/read/load_board.h"
#include "models/read/load_soil.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/plan/campaign_schema.h"
#include "sim/scenario/key_schema.h"
#include "sim/scenario/scenario_schema.h"

namespace dockyard {
namespace {

constexpr const char* kSchemaHelp =
    R"(Print the JSON Schema of a scenario, a campaign or a model, for editors.

Examples:
  dockyard schema scenario >out/scenario.schema.json
  dockyard schema campaign >out/campaign.schema.json
  dockyard schema soil >out/soil.schema.json

With it an editor completes and checks a file. The schema (draft 2020-12) has each key's type,
range, words, default and meaning. An editor with the YAML language server reads it if the first
line of a file names it, relative to the file:

  # yaml-language-server: $schema=../out/scenario.schema.json

A schema sees one file: `dockyard check` also reads the models, and values that depend on others.)";

/// Of all models whose keys are known, those of a system by "SYSTEM.KIND".
std::vector<ModelKeys> KindsOfModels(const std::vector<System>& systems) {
  std::vector<ModelKeys> kinds{{"soil",
                                [](Keys& keys) {
                                  SoilModel soil;
                                  VisitSoil(keys, soil);
                                }},
                               {"board", [](Keys& keys) {
                                  NamedBoard board;
                                  VisitNamedBoard(keys, board);
                                }}};
  for (const System& system : systems) {
    for (const ModelKeys& each : system.files.keys) {
      kinds.push_back({system.name + "." + each.kind, each.visit});
    }
  }
  return kinds;
}

Json SchemaOf(const std::string& of, const std::vector<System>& systems) {
  for (const ModelKeys& kind : KindsOfModels(systems)) {
    if (kind.kind != of) continue;
    return SchemaDocument("A file of Dockyard: " + of, SchemaOfModel(kind.visit));
  }
  const std::vector<KnownSystem> known = KnownSystems(systems);
  std::vector<SystemKeys> with_keys;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    with_keys.push_back({known[i], systems[i].keys});
  }
  return of == "scenario"
             ? SchemaDocument("A scenario of Dockyard", ScenarioSchema(with_keys, true))
             : SchemaDocument("A campaign of Dockyard", CampaignSchema(with_keys));
}

}  // namespace

void AddSchemaCommand(CLI::App& app, Invocation& call) {
  auto of = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("schema", kSchemaHelp);
  std::vector<std::string> kinds{"scenario", "campaign"};
  std::string of_models;
  for (const ModelKeys& kind : KindsOfModels(call.systems)) {
    kinds.push_back(kind.kind);
    of_models += (of_models.empty() ? "" : ", ") + kind.kind;
  }
  command->add_option("KIND", *of, "scenario, campaign, or of a model's file:\n" + of_models)
      ->required()
      ->check(CLI::IsMember(kinds));
  command->callback([of, &call] {
    std::printf("%s\n", SchemaOf(*of, call.systems).dump(1).c_str());
    call.exit_code = kExitDone;
  });
}

}  // namespace dockyard
