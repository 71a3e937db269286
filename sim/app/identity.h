// What a campaign's results depend on: its text, the files that it names, and this program.
#pragma once

#include <vector>

#include "sim/campaign/manifest.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// Of a campaign with absolute paths. Its files are models with all that they name (URDF, meshes
/// and the package.xml by which they are found, cameras), camera files and soils, and a
/// controller's program with the files that the scenario names for it.
/// Copies lie to each other as the files do. Throws IoError, and ConfigError for a model that is
/// not YAML.
CampaignIdentity IdentityOf(const Campaign& campaign, const std::vector<KnownSystem>& systems);

/// A sentence for each controller's program that lies with files of the same kind that the
/// scenario does not name: it may need them, and the results would lack them.
std::vector<std::string> UnnamedFilesOf(const Campaign& campaign,
                                        const std::vector<KnownSystem>& systems);

/// Where this program runs (sim/base/environment.h), for readers of results.
Json EnvironmentJson();

/// The campaign with the copies in `dir` in place of its files, but for controllers' programs,
/// which may need more than was copied.
Campaign OnCopies(const Campaign& campaign, const std::vector<KnownSystem>& systems,
                  const CampaignIdentity& identity, const std::filesystem::path& dir);

}  // namespace dockyard
