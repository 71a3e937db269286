// `dockyard check` as its users meet it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::json;

std::string Robot(const std::string& inside) {
  return "<robot name=\"m\">\n" + inside + "\n</robot>\n";
}

constexpr char kFaulty[] =
    "<link name=\"a\">\n<visual><geometry><box size=\"1 "
    "1\"/></geometry></visual>\n<visuals/></link>"
    "<gazebo/>";

TEST(CheckCommand, TellsTheFirstFaultAndAllOnRequest) {
  const ScratchFolder folder;
  const std::string file = folder.Write("m.urdf", Robot(kFaulty));
  const Ended first = Dockyard("check " + file), all = Dockyard("check --all " + file);
  EXPECT_EQ(first.code, 3);
  EXPECT_EQ(first.err, "error: " + file + ":3:19: <box>: size: expected 3 numbers, found '1 1'\n");
  EXPECT_EQ(all.code, 3);
  EXPECT_EQ(all.err, first.err + "error: " + file +
                         ":4:1: <visuals>: unknown element in <link>, did you mean 'visual'?\n");
}

TEST(CheckCommand, AnswersAsJson) {
  const ScratchFolder folder;
  const std::string bad = folder.Write("m.urdf", Robot(kFaulty));
  const std::string good = folder.Write("g.urdf", Robot("<link name=\"a\"/><gazebo/>"));
  const std::string mesh = folder.Write("mm.obj", "v 0 0 0\nv 400 0 0\nv 0 300 0\nf 1 2 3\n");
  const Ended ended = Dockyard("check --all --json " + bad + " " + good + " " + mesh);
  EXPECT_EQ(ended.code, 3);
  const Json answer = Json::parse(ended.out);
  const Json faults = {{{"file", bad},
                        {"line", 3},
                        {"column", 19},
                        {"text", "<box>: size: expected 3 numbers, found '1 1'"}},
                       {{"file", bad},
                        {"line", 4},
                        {"column", 1},
                        {"text", "<visuals>: unknown element in <link>, did you mean 'visual'?"}}};
  EXPECT_EQ(answer["faults"], faults);
  EXPECT_EQ(answer["left_out"], (Json{{"gazebo", 2}}));
  ASSERT_EQ(answer["files"].size(), 3u);
  EXPECT_EQ(answer["files"][0]["faults"], faults);
  EXPECT_EQ(answer["files"][1]["kind"], "urdf");
  EXPECT_EQ(answer["files"][1]["faults"], Json::array());
  EXPECT_THAT(answer["files"][2]["summary"].get<std::string>(), HasSubstr("400 x 300 x 0 m"));
  ASSERT_EQ(answer["warnings"].size(), 1u);
  EXPECT_THAT(answer["warnings"][0].get<std::string>(), HasSubstr("is it in millimetres?"));
  EXPECT_THAT(ended.err, HasSubstr("warning: " + mesh + ": its size is"));
}

TEST(CheckCommand, TellsAllFaultsOfTheUrdfThatARobotNames) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string robot = (folder.path() / "models/axel/axel.yaml").string();
  const std::string text = Slurp(folder.path() / "models/axel/axel.urdf");
  folder.Write("models/axel/axel.urdf",
               Replaced(text, "</robot>", "<visuals/>\n<collisions/>\n</robot>"));
  const Ended all = Dockyard("check --all " + robot);
  EXPECT_EQ(all.code, 3);
  EXPECT_THAT(all.err, HasSubstr("<visuals>: unknown element in <robot>"));
  EXPECT_THAT(all.err, HasSubstr("<collisions>: unknown element in <robot>"));
}

TEST(CheckCommand, WarnsOfTheUrdfThatARobotOrAScenarioNames) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  folder.CopyModel("soils");
  const std::string urdf = (folder.path() / "models/axel/axel.urdf").string();
  folder.Write("models/axel/axel.urdf",
               Replaced(Slurp(urdf), "</robot>",
                        "<gazebo/><link name=\"rod\"><inertial><mass value=\"0.01\"/><inertia "
                        "ixx=\"1e-6\" iyy=\"1e-6\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
                        "</inertial><contact/></link><joint name=\"rod_joint\" type=\"fixed\">"
                        "<parent link=\"body\"/><child link=\"rod\"/></joint></robot>"));
  const std::string scenario =
      folder.Write("scenarios/x.yaml", Slurp(SourceFile("scenarios/axel_typical.yaml")));
  const std::string campaign =
      folder.Write("scenarios/c.yaml", "campaign: c\nbase: x.yaml\nruns: [{run: 1}, {run: 2}]\n");
  for (const std::string& file :
       {(folder.path() / "models/axel/axel.yaml").string(), scenario, campaign}) {
    const Ended ended = Dockyard("check --json " + file);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json answer = Json::parse(ended.out);
    EXPECT_EQ(answer["left_out"], (Json{{"contact", 1}, {"gazebo", 1}})) << file;
    ASSERT_EQ(answer["warnings"].size(), 2u) << ended.out;
    for (const auto& [i, text] : {std::pair(0u, "link 'rod': inertia: a principal moment of 0"),
                                  std::pair(1u, "<contact> is left out")}) {
      const std::string warning = answer["warnings"][i].get<std::string>();
      EXPECT_THAT(warning, ::testing::StartsWith(urdf));
      EXPECT_THAT(warning, HasSubstr(text));
      EXPECT_THAT(ended.err, HasSubstr("warning: " + warning + "\n"));
    }
    EXPECT_THAT(answer["files"][0]["summary"].get<std::string>(),
                HasSubstr("; left out of " + urdf + ": 1 <contact>, 1 <gazebo>"));
  }
  const Json none = Json::parse(Dockyard("check --json models/axel/axel.yaml").out);
  EXPECT_EQ(none["warnings"], Json::array());
}

TEST(CheckCommand, HasNoLineForAFaultWithoutOne) {
  const Json answer = Json::parse(Dockyard("check --json /no/such.urdf").out);
  const Json fault = {
      {"file", "/no/such.urdf"}, {"line", nullptr}, {"column", nullptr}, {"text", "no such file"}};
  EXPECT_EQ(answer["faults"], Json::array({fault}));
}

// A link without mass may hang on a fixed joint; on another one no run can move it.
TEST(CheckCommand, WarnsOfALinkWithoutMassThatMoves) {
  const ScratchFolder folder;
  const auto Warnings = [&](const std::string& type, const std::string& tip) {
    const std::string file = folder.Write(
        "m.urdf", Robot("<link name=\"a\"/><link name=\"b\"/><link name=\"c\">" + tip +
                        "</link><joint name=\"j\" type=\"" + type +
                        "\"><parent link=\"a\"/><child link=\"b\"/></joint><joint name=\"k\" "
                        "type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>"));
    const Ended ended = Dockyard("check --json " + file);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(ended.out)["warnings"].dump();
  };
  const std::string massive =
      "<inertial><mass value=\"1\"/><inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" "
      "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
  EXPECT_THAT(Warnings("continuous", ""),
              HasSubstr("link 'b': it has no mass, and the continuous joint 'j' moves it"));
  EXPECT_EQ(Warnings("continuous", massive), "[]");
  EXPECT_EQ(Warnings("fixed", ""), "[]");
}

TEST(CheckCommand, TakesTheFoldersOfPackages) {
  const ScratchFolder folder;
  folder.Write("parts/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string file = folder.Write(
      "m.urdf", Robot("<link name=\"a\"><visual><geometry><mesh filename=\"package://p/a.obj\"/>"
                      "</geometry></visual></link>"));
  EXPECT_EQ(Dockyard("check " + file).code, 3);
  const std::string parts = (folder.path() / "parts").string();
  EXPECT_EQ(Dockyard("check --package p=" + parts + " " + file).code, 0);
  EXPECT_EQ(Dockyard("check " + file + " --package other=" + parts + " --package p=" + parts).code,
            0);
  EXPECT_EQ(Dockyard("check --package p " + file).code, 2);
  EXPECT_EQ(Dockyard("check --package p=/no/where " + file).code, 2);
}

}  // namespace
}  // namespace dockyard
