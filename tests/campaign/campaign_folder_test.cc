#include "sim/campaign/campaign_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "sim/base/files.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

std::string TakenOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const FolderTaken& error) {
    return error.what();
  }
  return "not taken";
}

/// A folder beside files that a campaign names.
class CampaignFolder : public testing::Test {
 protected:
  void SetUp() override { WriteText(dir_.path() / "rover.yaml", "mass_kg: 30\n"); }

  fs::path out() const { return dir_.path() / "out"; }
  CampaignIdentity Identity() const {
    return {"campaign: fake\nkeep: all\n",
            {{"version", "1"}},
            {{"files/rover.yaml", dir_.path() / "rover.yaml"}}};
  }
  std::string Claim(const CampaignIdentity& identity) const {
    return TakenOf([&] { ClaimFolder(out(), identity, {{"runs", 3}}); });
  }

  TemporaryFolder dir_;
};

TEST_F(CampaignFolder, HoldsTheCampaignAndCopiesOfItsFiles) {
  EXPECT_FALSE(HoldsCampaign(out()));
  EXPECT_EQ(Claim(Identity()), "not taken");
  EXPECT_TRUE(HoldsCampaign(out()));
  EXPECT_EQ(Slurp(out() / "campaign.yaml"), "campaign: fake\nkeep: all\n");
  EXPECT_EQ(Slurp(out() / "files/rover.yaml"), "mass_kg: 30\n");
  const std::string manifest = Slurp(out() / "manifest.json");
  EXPECT_THAT(manifest, HasSubstr("\"runs\": 3"));
  EXPECT_EQ(manifest.find(dir_.path().string()), std::string::npos) << "an absolute path";
}

TEST_F(CampaignFolder, IsRefusedToAnotherCampaign) {
  Claim(Identity());
  CampaignIdentity other = Identity();
  other.campaign_yaml += "seed: 2\n";
  EXPECT_THAT(Claim(other), HasSubstr("it holds another campaign: its campaign.yaml differs; "
                                      "choose another folder with --out"));
}

TEST_F(CampaignFolder, IsTheSameWithOtherLimitsAndLogs) {
  Claim(Identity());
  CampaignIdentity other = Identity();
  other.campaign_yaml = "campaign: fake\nkeep: none\nlimits: {wall_s: 3}\n";
  EXPECT_EQ(Claim(other), "not taken");
}

TEST_F(CampaignFolder, IsRefusedToAnotherProgram) {
  Claim(Identity());
  CampaignIdentity other = Identity();
  other.program["version"] = "2";
  EXPECT_THAT(Claim(other), HasSubstr("begun with another program: in its manifest.json "
                                      "'version' differs"));
}

TEST_F(CampaignFolder, IsRefusedToOtherContentOfAFile) {
  Claim(Identity());
  WriteText(dir_.path() / "rover.yaml", "mass_kg: 31\n");
  EXPECT_THAT(Claim(Identity()), HasSubstr("begun with another files/rover.yaml"));
}

TEST_F(CampaignFolder, IsTheSameWhereverItsFilesAre) {
  Claim(Identity());
  fs::create_directories(dir_.path() / "elsewhere");
  WriteText(dir_.path() / "elsewhere/rover.yaml", "mass_kg: 30\n");
  CampaignIdentity moved = Identity();
  moved.files["files/rover.yaml"] = dir_.path() / "elsewhere/rover.yaml";
  EXPECT_EQ(Claim(moved), "not taken");
}

TEST_F(CampaignFolder, OverwritesNothingThatIsNotItsOwn) {
  for (const char* name : {"thesis.tex", "files"}) {
    const TemporaryFolder full;
    WriteText(full.path() / name, "five years of work");
    EXPECT_THAT(TakenOf([&] { ClaimFolder(full.path(), Identity(), {}); }),
                HasSubstr("is not empty and holds no campaign"));
    EXPECT_EQ(Slurp(full.path() / name), "five years of work");
  }
}

TEST_F(CampaignFolder, WhoseClaimWasCutShortIsMadeWhole) {
  Claim(Identity());
  fs::remove(out() / "campaign.yaml");
  fs::remove(out() / "files/rover.yaml");
  EXPECT_EQ(Claim(Identity()), "not taken");
  EXPECT_EQ(Slurp(out() / "files/rover.yaml"), "mass_kg: 30\n");
}

TEST_F(CampaignFolder, ThatCannotBeMadeIsAnIoError) {
  EXPECT_THROW(ClaimFolder("/proc/nothing/here", Identity(), {}), IoError);
  EXPECT_THROW(ClaimFolder(dir_.path() / "rover.yaml", Identity(), {}), IoError);
  fs::remove(dir_.path() / "rover.yaml");
  EXPECT_THROW(ClaimFolder(out(), Identity(), {}), IoError);
}

}  // namespace
}  // namespace dockyard
