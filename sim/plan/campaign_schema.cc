#include "sim/plan/campaign_schema.h"

#include "controller/base/check.h"
#include "sim/plan/campaign_keys.h"
#include "sim/scenario/key_schema.h"

namespace dockyard {
namespace {

Json Number() { return {{"type", "number"}}; }
Json Positive() { return {{"type", "number"}, {"exclusiveMinimum", 0}}; }
Json Text() { return {{"type", "string"}, {"minLength", 1}}; }
Json Whole(std::int64_t low, std::int64_t high) {
  return {{"type", "integer"}, {"minimum", low}, {"maximum", high}};
}
Json Flag() { return {{"type", "boolean"}}; }
Json Ref(const char* name) { return {{"$ref", std::string("#/$defs/") + name}}; }

Json Mapping(const Json& properties, const std::vector<std::string>& required = {}) {
  Json schema{{"type", "object"}, {"properties", properties}};
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

Json List(const Json& items, std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", items}, {"minItems", least}, {"maxItems", most}};
}

/// Names and seeds follow from the runs' numbers, and all runs are of one system.
Json SettableKeys(const Json& values, std::size_t most) {
  return {{"type", "object"},
          {"propertyNames", {{"not", {{"enum", {"name", "seed", "system"}}}}}},
          {"additionalProperties", values},
          {"minProperties", 1},
          {"maxProperties", most}};
}

/// A list of values, a range, or labels with values.
Json FactorSchema() {
  const Json range =
      Mapping({{"from", Number()}, {"to", Number()}, {"step", Positive()}}, {"from", "to", "step"});
  const Json labels{{"type", "object"},
                    {"not", {{"required", Json::array({"from"})}}},
                    {"minProperties", 1},
                    {"maxProperties", kMostFactorValues}};
  return {{"anyOf", {List(true, 1, kMostFactorValues), range, labels}}};
}

Json DrawSchema() {
  const Json bounds = Mapping({{"min", Number()}, {"max", Number()}}, {"min", "max"});
  const Json positive = Mapping({{"min", Positive()}, {"max", Positive()}}, {"min", "max"});
  const Json normal =
      Mapping({{"mean", Number()}, {"std", Positive()}, {"min", Number()}, {"max", Number()}},
              {"mean", "std"});
  const Json weights = List({{"type", "number"}, {"minimum", 0}}, 1, kMostFactorValues);
  const Json discrete = Mapping({{"values", Ref("factor")}, {"weights", weights}}, {"values"});
  Json distribution = Mapping(
      {{"normal", normal}, {"uniform", bounds}, {"loguniform", positive}, {"discrete", discrete}});
  DOCKYARD_CHECK(distribution["properties"].size() == DistributionWords().size());
  distribution["minProperties"] = 1;
  distribution["maxProperties"] = 1;
  return {{"anyOf", {{{"enum", {"assumed", "tolerance"}}}, distribution}}};
}

Json KeepSchema() {
  constexpr int kMost = 1000000000;
  const Json parts = Mapping({{"failures_per_cause", Whole(0, kMost)},
                              {"every_nth_success", Whole(0, kMost)},
                              {"pictures", Flag()},
                              {"sightings", Flag()}});
  return {{"anyOf", {{{"enum", {"all", "none"}}}, parts}}};
}

Json LimitsSchema() {
  const Json wall{{"type", "number"}, {"minimum", 0.001}, {"maximum", 1e6}};
  return Mapping({{"wall_s", wall}, {"memory_mib", Whole(64, 1 << 24)}, {"retries", Whole(0, 10)}});
}

Json RunsSchema() {
  const Json row{{"type", "object"},
                 {"properties", {{"run", Whole(0, 2000000000)}}},
                 {"required", Json::array({"run"})}};
  return List(row, 1, 1000000);
}

Json SchemaOf(const std::string& key, const std::vector<SystemKeys>& systems) {
  if (key == "campaign")
    return {{"type", "string"}, {"maxLength", 100}, {"pattern", "^[^./][^/]*$"}};
  if (key == "seed") return SeedSchema();
  if (key == "base" || key == "table") return Text();
  if (key == "scenario") return ScenarioSchema(systems, false);
  if (key == "script") return {{"type", "array"}};
  if (key == "arms") {
    return {
        {"type", "object"}, {"additionalProperties", {{"type", "object"}}}, {"minProperties", 1}};
  }
  if (key == "vary" || key == "one_at_a_time") return SettableKeys(Ref("factor"), kMostFactors);
  if (key == "draw") return SettableKeys(Ref("draw"), kMostDraws);
  if (key == "correlate") {
    const Json rank{{"type", "number"}, {"minimum", -1}, {"maximum", 1}};
    return List(Mapping({{"keys", List(Text(), 2, 2)}, {"rank", rank}}, {"keys", "rank"}), 1, 1000);
  }
  if (key == "design") {
    return Mapping({{"kind", {{"enum", DesignWords()}}}, {"runs", Whole(1, 1000000000)}});
  }
  if (key == "tags") return List(Text(), 1, 100);
  if (key == "runs") return RunsSchema();
  if (key == "keep") return KeepSchema();
  if (key == "limits") return LimitsSchema();
  DOCKYARD_CHECK(key == "figures");
  return Mapping(
      {{"x", Text()}, {"curves", Text()}, {"panels", Text()}, {"measures", List(Text(), 1, 8)}});
}

}  // namespace

Json CampaignSchema(const std::vector<SystemKeys>& systems) {
  Json properties = Json::object();
  for (const CampaignKey& key : CampaignKeys()) {
    Json schema = SchemaOf(key.name, systems);
    schema["description"] = key.meaning;
    properties[key.name] = std::move(schema);
  }
  Json schema = Mapping(properties, {"campaign"});
  const auto has = [](const char* key) { return Json{{"required", Json::array({key})}}; };
  schema["anyOf"] = Json::array({has("base"), has("scenario")});
  schema["not"] = {{"required", {"table", "runs"}}};
  schema["$defs"] = {{"factor", FactorSchema()}, {"draw", DrawSchema()}};
  return schema;
}

}  // namespace dockyard
