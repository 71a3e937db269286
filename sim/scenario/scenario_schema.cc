#include "sim/scenario/scenario_schema.h"

#include <algorithm>

#include "sim/scenario/key_schema.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

/// Of a scenario that is of this system.
Json SchemaOf(const SystemKeys& system, bool whole) {
  Scenario scenario;
  scenario.system = system.known.name;
  Json schema =
      SchemaOfKeys([&](Keys& keys) { VisitScenario(keys, scenario, {system.known}); }, whole);
  if (system.visit) {
    Json own = SchemaOfKeys(system.visit, whole);
    own["description"] = "keys of the system " + system.known.name;
    schema["properties"][system.known.name] = own;
  }
  return schema;
}

/// In a scenario of one system the keys of others are refused.
Json RuleOf(const SystemKeys& system, const Json& its, const std::vector<SystemKeys>& systems) {
  Json properties{{"controller", its["properties"]["controller"]},
                  {"start", its["properties"]["start"]}};
  for (const SystemKeys& other : systems) {
    if (other.known.name != system.known.name) properties[other.known.name] = false;
  }
  return {{"if",
           {{"properties", {{"system", {{"const", system.known.name}}}}},
            {"required", Json::array({"system"})}}},
          {"then", {{"properties", properties}}}};
}

}  // namespace

Json ScenarioSchema(const std::vector<SystemKeys>& systems, bool whole) {
  Json schema, names = Json::array(), controllers = Json::array(), starts = Json::array(),
               rules = Json::array();
  for (const SystemKeys& system : systems) {
    const Json its = SchemaOf(system, whole);
    if (schema.is_null()) schema = its;
    const std::string& name = system.known.name;
    schema["properties"][name] = its["properties"][name];
    names.push_back(name);
    controllers.push_back(its["properties"]["controller"]);
    const Json& start = its["properties"]["start"];
    if (std::find(starts.begin(), starts.end(), start) == starts.end()) starts.push_back(start);
    rules.push_back(RuleOf(system, its, systems));
  }
  if (systems.empty()) return {{"type", "object"}};
  schema["properties"]["system"]["enum"] = names;
  schema["properties"]["controller"] = {{"anyOf", controllers}};
  if (starts.size() > 1) schema["properties"]["start"] = {{"anyOf", starts}};
  schema["allOf"] = rules;
  return schema;
}

Json SchemaDocument(const std::string& title, const Json& schema) {
  Json document{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  document.update(schema);
  return document;
}

}  // namespace dockyard
