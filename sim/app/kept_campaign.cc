#include "sim/app/kept_campaign.h"

#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "models/read/yaml_path.h"
#include "sim/app/commands.h"
#include "sim/app/scenario_options.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/manifest.h"
#include "sim/campaign/merge.h"
#include "sim/plan/file_keys.h"
#include "sim/plan/make_run.h"
#include "sim/report/points.h"

namespace dockyard {
namespace {

/// What the manifest says of the secret; empty: the campaign is not sealed.
std::string SealOf(const std::filesystem::path& dir) {
  const Json manifest = ReadManifest(dir);
  if (!manifest.contains(kSealedSha256)) return "";
  const Json& seal = manifest[kSealedSha256];
  return seal.is_string() ? seal.get<std::string>() : "not a text";
}

void GiveSecret(const Secret& secret, Campaign& campaign) {
  if (campaign.sealed_sha256.empty()) {
    throw UsageError("--secret: expected none, as the campaign is not sealed");
  }
  if (campaign.sealed_sha256 != Fingerprint(secret)) {
    throw UsageError("--secret: expected the secret whose SHA-256 is " + campaign.sealed_sha256 +
                     ", found one with " + Fingerprint(secret));
  }
  campaign.Seal(secret);
}

}  // namespace

void RefuseResultsFolder(const std::filesystem::path& dir, const std::string& expected) {
  std::error_code ignored;
  const bool there = std::filesystem::exists(dir, ignored);
  const bool folder = std::filesystem::is_directory(dir, ignored);
  throw UsageError("DIR: expected " + expected + ", found " +
                   (folder  ? "no results in '"
                    : there ? "the file '"
                            : "no folder '") +
                   dir.string() + "'" + DidYouMeanFile(dir));
}

void AddSecretOption(CLI::App& command, Invocation& call) {
  command
      .add_option("--secret", call.secret_file, "of a sealed campaign, to make its worlds again")
      ->type_name("FILE");
}

Secret SecretIn(const std::string& file, bool make) {
  try {
    return make ? ReadOrMakeSecret(file) : ReadSecret(file);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(error.what());
  }
}

KeptCampaign OpenKeptCampaign(const std::filesystem::path& dir, const std::vector<System>& systems,
                              const std::string& secret_file) {
  if (!HoldsCampaign(dir)) RefuseResultsFolder(dir, "the results folder of a campaign");
  KeptCampaign kept;
  kept.campaign = WithAbsolutePaths(
      LoadCampaign((dir / "campaign.yaml").string(), {}, CampaignSystemsOf(systems)),
      KnownSystems(systems));
  kept.campaign.sealed_sha256 = SealOf(dir);
  if (!secret_file.empty()) GiveSecret(SecretIn(secret_file, false), kept.campaign);
  const YamlNode* system = FindPath(kept.campaign.base, "system");
  if (system == nullptr) throw ConfigError((dir / "campaign.yaml").string() + ": no system");
  kept.system = system->scalar;
  kept.columns = FindSystem(systems, kept.system).Columns(kept.campaign.labels);
  return kept;
}

KeptCampaign ReadKeptCampaign(const std::filesystem::path& dir, const std::vector<System>& systems,
                              const std::string& secret_file) {
  KeptCampaign kept = OpenKeptCampaign(dir, systems, secret_file);
  kept.runs = ReadShards(dir, RowCheck(kept.campaign), kept.columns);
  LeaveOutUncounted(dir, kept.runs);
  return kept;
}

void RequireArm(const KeptCampaign& kept, const std::string& arm) {
  std::string names;
  for (const Arm& each : kept.campaign.arms) {
    if (each.name == arm) return;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  throw UsageError("expected an arm of the campaign (" + (names.empty() ? "it has none" : names) +
                   "), found '" + arm + "'");
}

std::vector<const RunResult*> RunsOfArm(const KeptCampaign& kept, const std::string& arm) {
  std::vector<const RunResult*> rows;
  for (const RunResult& result : kept.runs.results) {
    if (arm.empty() || LabelOf(result, kept.columns, "arm") == arm) rows.push_back(&result);
  }
  return rows;
}

}  // namespace dockyard
