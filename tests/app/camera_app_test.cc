// The camera command as an engineer uses it on a camera file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "support/fake_runs.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kMars = "tests/models/data/m2020_cameras.json";
const std::string kNavcam = "models/cameras/navcam.yaml";

Json Answer(const std::string& arguments) {
  const Ended ended = Dockyard("camera " + arguments + " --json");
  EXPECT_EQ(ended.code, 0) << arguments << "\n" << ended.err;
  return Json::parse(ended.out);
}

// Reference: the equations of docs/reference/cameras.md in another language, O brought to length 1.
TEST(CameraCommand, ProjectsThroughAPublishedHazcam) {
  const Json answer = Answer("project " + kMars + " 3 0.2 0.5 --name HAZFLA");
  EXPECT_NEAR(answer.at("pixel").at(0).get<double>(), 3140.325646955424, 1e-6);
  EXPECT_NEAR(answer.at("pixel").at(1).get<double>(), 2172.9598808900378, 1e-6);
  EXPECT_EQ(answer.at("in_image"), true);
  EXPECT_EQ(answer.at("warnings"), Json::array());
}

TEST(CameraCommand, GivesRaysThatProjectBackToTheirPixel) {
  for (const std::string& camera : {kMars + " %s --name NAVR", kNavcam + " %s --name right"}) {
    const auto with = [&](const std::string& numbers) {
      std::string text = camera;
      return text.replace(text.find("%s"), 2, numbers);
    };
    const Json ray = Answer("ray " + with("77.25 310.5"));
    std::string point;
    double length = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double d = ray.at("direction").at(i);
      char number[32];
      std::snprintf(number, sizeof number, " %.17g",
                    ray.at("origin").at(i).get<double>() + 0.7 * d);
      point += number;
      length += d * d;
    }
    EXPECT_NEAR(length, 1.0, 1e-14);
    const Json back = Answer("project " + with(point));
    EXPECT_NEAR(back.at("pixel").at(0).get<double>(), 77.25, 1e-8);
    EXPECT_NEAR(back.at("pixel").at(1).get<double>(), 310.5, 1e-8);
  }
}

TEST(CameraCommand, TakesOneJsonObjectWithoutAName) {
  const TemporaryFolder folder;
  const Json all = Json::parse(Slurp(SourceFile(kMars)));
  const fs::path one = folder.path() / "one.json";
  WriteText(one, all.at(2).dump());
  const Json answer = Answer("project " + one.string() + " 0 0 1");
  EXPECT_NEAR(answer.at("pixel").at(0).get<double>(), all.at(2).at("model").at("H").at(2), 0.05);
}

TEST(CameraCommand, AnswersNoneForWhatCannotBeSeen) {
  const Json behind = Answer("project " + kNavcam + " -3 0 0 --name left");
  EXPECT_TRUE(behind.at("pixel").is_null());
  EXPECT_THAT(behind.at("reason").get<std::string>(), HasSubstr("behind"));
  const Json far = Answer("ray models/cameras/axel_640.yaml 1e5 0 --name left");
  EXPECT_TRUE(far.at("direction").is_null());
  const Ended text = Dockyard("camera project " + kNavcam + " -3 0 0 --name left");
  EXPECT_EQ(text.code, 0);
  EXPECT_THAT(text.out, HasSubstr("pixel     none"));
}

TEST(CameraCommand, TellsWhatIsWrongWithItsFileAndItsArguments) {
  const TemporaryFolder folder;
  const std::string bad = (folder.path() / "bad.json").string();
  WriteText(bad, "{\n  \"name\": \"x\",\n  \"model\": {\"type\": \"cahvx\"}\n}\n");
  const Ended wrong = Dockyard("camera project " + bad + " 1 2 3");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_THAT(wrong.err,
              HasSubstr(bad + ":3:21: model.type: expected one of cahv, cahvor, cahvore"));
  EXPECT_EQ(Dockyard("camera ray " + kMars + " 1 2").code, 3);  // which of its five?
  EXPECT_EQ(Dockyard("camera project " + kMars + " 1 2 --name NAVL").code, 2);
  EXPECT_EQ(Dockyard("camera project " + kMars + " 1 2 nan --name NAVL").code, 2);
  EXPECT_EQ(Dockyard("camera").code, 2);
}

}  // namespace
}  // namespace dockyard
