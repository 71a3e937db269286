#include "sim/campaign/manifest.h"

#include <string_view>

#include "sim/base/files.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

/// The first name in either object whose values differ; empty if there is none.
std::string FirstDifference(const Json& a, const Json& b) {
  for (const auto& [name, value] : a.items()) {
    if (!b.contains(name) || b[name] != value) return name;
  }
  for (const auto& [name, value] : b.items()) {
    if (!a.contains(name)) return name;
  }
  return "";
}

Json ObjectAt(const Json& json, const char* name) {
  return json.is_object() && json.contains(name) && json[name].is_object() ? json[name]
                                                                           : Json::object();
}

}  // namespace

Json MakeManifest(const CampaignIdentity& identity, const Json& facts) {
  Json files = Json::object();
  for (const auto& [copy, original] : identity.files) {
    const auto bytes = ReadWhole(original);
    if (!bytes) throw IoError("cannot read " + original.string() + ": it is not there");
    files[copy] = HexText(HashText(kHashSeed, *bytes));
  }
  const std::string campaign = WithoutSettings(identity.campaign_yaml);
  Json manifest{{"format", kResultsFormat},
                {"campaign", HexText(HashText(kHashSeed, campaign))},
                {"facts", facts},
                {"program", identity.program.is_null() ? Json::object() : identity.program},
                {"files", files}};
  if (!identity.sealed_sha256.empty()) manifest[kSealedSha256] = identity.sealed_sha256;
  return manifest;
}

std::string ManifestDifference(const Json& kept, const Json& wanted) {
  if (!kept.is_object() || kept.value("format", 0) != kResultsFormat) {
    return "its manifest.json is of another version of the program";
  }
  if (kept.value("campaign", "") != wanted.value("campaign", "")) {
    return "it holds another campaign: its campaign.yaml differs";
  }
  const std::string sealed = kept.value(kSealedSha256, ""), seal = wanted.value(kSealedSha256, "");
  if (sealed != seal) {
    return sealed.empty() ? "it was begun without --sealed"
           : seal.empty() ? "it is sealed: expected --sealed and the secret that it was begun with"
                          : "it is sealed by another secret";
  }
  const std::string of_program =
      FirstDifference(ObjectAt(kept, "program"), ObjectAt(wanted, "program"));
  if (!of_program.empty()) {
    return "it was begun with another program: in its manifest.json '" + of_program + "' differs";
  }
  const std::string file = FirstDifference(ObjectAt(kept, "files"), ObjectAt(wanted, "files"));
  if (!file.empty()) return "it was begun with another " + file;
  return "";
}

std::string WithoutSettings(const std::string& campaign_yaml) {
  std::string text;
  std::string_view rest = campaign_yaml;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size() - 1) + 1;
    const std::string_view line = rest.substr(0, end);
    if (!line.starts_with("keep: ") && !line.starts_with("limits: ")) text += line;
    rest.remove_prefix(end);
  }
  return text;
}

}  // namespace dockyard
