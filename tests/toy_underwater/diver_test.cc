// A vehicle with six degrees of freedom, a start and sensors of its own goes through the whole
// program; no generic room has a line for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/program.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/log/logged_run.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kDiver = "tests/toy_underwater/";

class Diver : public testing::Test {
 protected:
  std::string dir(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string Text(const std::string& file) const {
    return ReadWhole(folder_.path() / file).value_or("");
  }
  TemporaryFolder folder_;
};

TEST_F(Diver, IsCheckedAndRefusesAStartOfThePlane) {
  const Ended good = Dockyard("check " + kDiver + "scenario.yaml");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_THAT(good.out, HasSubstr("a diver in a current of 0.1 m/s"));
  EXPECT_THAT(Dockyard("check " + kDiver + "campaign.yaml").code, 0);
  const Ended rover = Dockyard("run " + kDiver +
                               "scenario.yaml --set "
                               "'start={r_m: 4, alpha_deg: 0, heading_deg: 0}'");
  EXPECT_EQ(rover.code, 3);
  EXPECT_THAT(rover.err, HasSubstr("unknown key 'start.r_m'"));
  const Ended misspelt = Dockyard("run " + kDiver + "scenario.yaml --set start.uo_m=1");
  EXPECT_THAT(misspelt.err, HasSubstr("unknown key 'start.uo_m', did you mean 'start.up_m'?"));
}

TEST_F(Diver, SwimsIntoItsCageAndIsReplayed) {
  const Ended run = Dockyard("run " + kDiver + "scenario.yaml --json --out " + dir("run"));
  ASSERT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_EQ(Json::parse(run.out)["outcome"], "caged");
  const LoggedRun log = ReadLoggedRun(folder_.path() / "run");
  EXPECT_EQ(log.truth.at("z_m").front(), -2.0);
  EXPECT_NEAR(log.truth.at("z_m").back(), 0.0, 0.15);
  // A depth of 14 m at the start, to four of its deviations.
  EXPECT_NEAR(log.sensors.at("depth_m").front(), 14.0, 4 * 0.005);
  EXPECT_NEAR(log.sensors.at("range_m").front(), std::hypot(8.0, 2.0), 4 * 0.05);
  double worst_m = 0.0;
  for (std::size_t i = 0; i < log.times_s.size(); ++i) {
    worst_m = std::max(worst_m, std::abs(log.belief.at("z_m")[i] - log.truth.at("z_m")[i]));
  }
  EXPECT_LT(worst_m, 0.05);
  const Ended replay = Dockyard("replay " + dir("run"));
  EXPECT_EQ(replay.code, 0) << replay.err;
  EXPECT_THAT(replay.out,
              AllOf(HasSubstr("same result row, bit for bit"), HasSubstr("same commands at all")));
  const Ended report = Dockyard("report " + dir("run") + " --out " + dir("run.html"));
  EXPECT_EQ(report.code, 0) << report.err;
  const Json limits = Json::parse(Text("run/outcome.json"))["limits"];
  ASSERT_EQ(limits.size(), 1u);
  EXPECT_GT(limits[0]["margin"].get<double>(), 0.0);
  const Ended view =
      Dockyard("view " + kDiver + "scenario.yaml --outside --time 5 --out " + dir("view"));
  EXPECT_EQ(view.code, 0) << view.err;
}

TEST_F(Diver, IsVariedOverItsOwnStartInACampaign) {
  const Ended end =
      Dockyard("campaign " + kDiver + "campaign.yaml --quiet --out " + dir("campaign"));
  ASSERT_EQ(end.code, 0) << end.out << end.err;
  EXPECT_THAT(Text("campaign/results.csv"),
              AllOf(HasSubstr("start.range_m"), HasSubstr("start.up_m"), HasSubstr(",caged,"),
                    HasSubstr("margin.nose_depth_m")));
  EXPECT_THAT(Text("campaign/summary.txt"), HasSubstr("range_m"));
  const Ended report = Dockyard("report " + dir("campaign") + " --out " + dir("campaign.html"));
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_THAT(Text("campaign.html"), HasSubstr("start"));
  EXPECT_EQ(Dockyard("replay " + dir("campaign") + " 1").code, 0);
}

TEST_F(Diver, HasItsStartInTheSchema) {
  const Json schema = Json::parse(Dockyard("schema scenario").out);
  const Json& start = schema["properties"]["start"]["properties"];
  EXPECT_EQ(start["up_m"]["minimum"], -10.0);
  EXPECT_FALSE(start.contains("r_m"));
}

}  // namespace
}  // namespace dockyard
