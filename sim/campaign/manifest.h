// manifest.json of a results folder: what was run, and with what.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "sim/base/json.h"

namespace dockyard {

inline constexpr int kResultsFormat = 1;
inline constexpr const char* kSealedSha256 = "sealed_sha256";

/// What a results folder belongs to. It holds no absolute path, so that the same campaign is the
/// same on another computer.
struct CampaignIdentity {
  std::string campaign_yaml;  // with the copies' paths in place of the files'
  Json program;               // an object: version, fingerprint and the like
  /// Copies in the folder ("files/axel/axel.yaml") and the files that they are made from.
  std::map<std::string, std::filesystem::path> files;
  std::string sealed_sha256 = {};  // of a sealed campaign: the fingerprint of its secret
};

/// The manifest of a new folder. Throws IoError for a file that cannot be read.
Json MakeManifest(const CampaignIdentity& identity, const Json& facts);

/// How the two differ, as a phrase for people; empty when they do not. `facts` are not compared.
std::string ManifestDifference(const Json& kept, const Json& wanted);

/// As campaign.yaml, without what does not change a result: which logs are kept, and limits.
std::string WithoutSettings(const std::string& campaign_yaml);

}  // namespace dockyard
