// Campaigns whose worlds a secret seals, and the audit of their rows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "app/program.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Sealed : public testing::Test {
 protected:
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Text(const std::string& name) const { return ReadWhole(At(name)).value_or(""); }
  Ended Campaign(const std::string& dir, const std::string& options) {
    return Dockyard("campaign tests/toy/draws.yaml --quiet --out " + At(dir) + " " + options);
  }
  std::string SealedBy(const std::string& secret) const { return "--sealed " + At(secret); }

  ScratchFolder folder_;
};

TEST_F(Sealed, TheSecretAloneMakesTheWorlds) {
  for (const auto& [dir, secret] : {std::pair{"a", "one"}, {"b", "one"}, {"c", "two"}}) {
    const Ended end = Campaign(dir, SealedBy(secret));
    ASSERT_EQ(end.code, 0) << end.err;
  }
  ASSERT_EQ(Campaign("plain", "").code, 0);
  EXPECT_EQ(Text("a/results.csv"), Text("b/results.csv"));
  EXPECT_NE(Text("a/results.csv"), Text("c/results.csv"));
  EXPECT_NE(Text("a/results.csv"), Text("plain/results.csv"));
}

TEST_F(Sealed, TheFolderHasTheFingerprintAndNotTheSecret) {
  ASSERT_EQ(Campaign("a", SealedBy("one")).code, 0);
  const Json manifest = Json::parse(Text("a/manifest.json"));
  EXPECT_EQ(manifest.at("sealed_sha256").get<std::string>().size(), 64u);
  const std::string secret = Text("one").substr(0, 32);
  for (const auto& entry : fs::recursive_directory_iterator(At("a"))) {
    if (!entry.is_regular_file()) continue;
    EXPECT_THAT(ReadWhole(entry.path()).value_or(""), Not(HasSubstr(secret))) << entry.path();
  }
}

TEST_F(Sealed, GoesOnWithItsSecretAlone) {
  ASSERT_EQ(Campaign("a", SealedBy("one")).code, 0);
  EXPECT_EQ(Campaign("a", SealedBy("one")).code, 0);
  const Ended without = Campaign("a", ""), other = Campaign("a", SealedBy("two"));
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("it is sealed: expected --sealed"));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("it is sealed by another secret"));
}

TEST_F(Sealed, RowsAreJudgedWithoutTheSecretAndReplayedWithIt) {
  ASSERT_EQ(Campaign("a", SealedBy("one")).code, 0);
  EXPECT_EQ(Dockyard("merge " + At("a")).code, 0);
  const Ended hidden = Dockyard("replay " + At("a") + " 1");
  EXPECT_EQ(hidden.code, 3);
  EXPECT_THAT(hidden.err, HasSubstr("expected its secret, --secret FILE"));
  ASSERT_EQ(Campaign("b", SealedBy("two")).code, 0);
  const Ended wrong = Dockyard("replay " + At("a") + " 1 --secret " + At("two"));
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("expected the secret whose SHA-256 is"));
  EXPECT_THAT(Dockyard("replay " + At("a") + " 1 --secret " + At("one")).out,
              HasSubstr("same result row, bit for bit"));
}

TEST_F(Sealed, ASecretOfOtherContentIsRefusedWithItsFile) {
  folder_.Write("one", "not a secret");
  const Ended end = Campaign("a", SealedBy("one"));
  EXPECT_EQ(end.code, 3);
  EXPECT_THAT(end.err, HasSubstr("one: expected 32 hexadecimal digits"));
}

TEST_F(Sealed, AnAuditFindsARowThatWasChanged) {
  ASSERT_EQ(Campaign("a", SealedBy("one")).code, 0);
  const std::string audit = "audit " + At("a") + " --sample 1000 --json --secret " + At("one");
  const Ended good = Dockyard(audit);
  EXPECT_EQ(good.code, 0) << good.err;
  const Json same = Json::parse(good.out);
  EXPECT_EQ(same.at("same"), same.at("sampled"));
  EXPECT_TRUE(same.at("differs").empty());
  // The rows of other worlds under this campaign's name: with the plain seed they are all wrong.
  ASSERT_EQ(Campaign("c", SealedBy("two")).code, 0);
  fs::remove_all(At("a/shards"));
  fs::copy(At("c/shards"), At("a/shards"), fs::copy_options::recursive);
  const Ended bad = Dockyard(audit);
  EXPECT_NE(bad.code, 0) << bad.out;
}

TEST_F(Sealed, AnAuditMissesRowsThatWereTakenAwayAndSeesChangedLines) {
  ASSERT_EQ(Campaign("a", "").code, 0);
  const std::string audit = "audit " + At("a") + " --sample 1000 --json";
  const std::string table = Text("a/results.csv");
  const std::size_t place = table.find("at_flag");
  ASSERT_NE(place, std::string::npos);
  folder_.Write("a/results.csv", table.substr(0, place) + "missed" + table.substr(place + 7));
  const Ended changed = Dockyard(audit);
  EXPECT_EQ(changed.code, 1);
  EXPECT_THAT(changed.out, HasSubstr("its line in results.csv is not its row"));
  folder_.Write("a/results.csv", table);
  EXPECT_EQ(Dockyard(audit).code, 0);
  std::string rows = Text("a/shards/1-of-1.rows");
  rows.erase(rows.rfind('\n', rows.size() - 2) + 1);
  folder_.Write("a/shards/1-of-1.rows", rows);
  EXPECT_EQ(Dockyard(audit).code, 1);  // the table has it
  fs::remove(At("a/results.csv"));
  const Ended missing = Dockyard(audit);
  EXPECT_EQ(missing.code, 10);
  EXPECT_THAT(missing.out, HasSubstr("it has no row"));
}

TEST_F(Sealed, AnAuditComparesAsManyRowsAsAsked) {
  ASSERT_EQ(Campaign("a", "").code, 0);
  const Json answer = Json::parse(Dockyard("audit " + At("a") + " --sample 2 --json").out);
  EXPECT_EQ(answer.at("sampled"), 2);
  EXPECT_EQ(answer.at("same"), 2);
  EXPECT_THAT(Dockyard("audit " + At("a") + " --secret " + At("none")).err,
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace dockyard
