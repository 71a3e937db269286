// Limits on the size of a URDF file and on the time that a hostile one takes.
#include <gmock/gmock.h>

#include <chrono>
#include <functional>

#include "models/urdf_messages.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

TEST(Urdf, IsNotNestedWithoutBoundNorHasADoctype) {
  std::string deep = "<robot name=\"m\">";
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(UrdfMessage(deep), HasSubstr("nested deeper than 64 levels"));
  EXPECT_THAT(UrdfMessage("<!DOCTYPE x [<!ENTITY a \"b\">]><robot name=\"m\"/>"),
              HasSubstr("DOCTYPE"));
}

/// `text` n times.
std::string Times(std::size_t n, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < n; ++i) all += text;
  return all;
}

double Seconds(const std::function<void()>& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Urdf, NestingIsCountedOutsideCommentsCdataAndAttributes) {
  const std::string deep = Times(40000, "<a>") + Times(40000, "</a>");
  const std::string up = Times(40000, "</a>");
  for (const std::string& hidden :
       {"<!-- " + up + " -->", "<![CDATA[" + up + "]]>", "<b c=\"" + up.substr(0, 4000) + "\"/>"}) {
    EXPECT_THAT(UrdfMessage("<robot name=\"m\">" + hidden + deep + "</robot>"),
                HasSubstr("nested deeper than 64 levels"));
  }
  EXPECT_EQ(
      UrdfMessage("<robot name=\"m\"><!-- " + Times(100, "<a>") + " --><link name=\"a\"/></robot>"),
      "(no error)");
}

TEST(Urdf, BrokenTagsAreRefusedInLinearTime) {
  // 3.8 MB took more than 60 s where every '<' looked for its '>' anew; now 0.2 s.
  const auto call = [] {
    EXPECT_THAT(UrdfMessage("<robot>" + Times(1900000, "<a") + "/>"),
                HasSubstr("m.urdf:1:8: not usable XML: a tag without its end"));
  };
  EXPECT_LT(Seconds(call), 10.0);
}

TEST(Urdf, OneTagHoldsABoundedNumberOfAttributes) {
  // Each attribute of a tag is compared with all others.
  std::string tag = "<robot name=\"m\"><link name=\"a\"";
  for (int i = 0; i < 100000; ++i) tag += " a" + std::to_string(i) + "=\"\"";
  EXPECT_THAT(UrdfMessage(tag + "/></robot>"), HasSubstr("a tag of more than 8192 bytes"));
}

TEST(Urdf, AllPartsOfAFileTogetherAreBounded) {
  const auto robot = [](int links, int parts, const std::string& geometry) {
    std::string text = "<link name=\"root\"/>";
    for (int i = 0; i < links; ++i) {
      const std::string name = std::to_string(i);
      text += "<link name=\"" + name + "\">" +
              Times(static_cast<std::size_t>(parts),
                    "<collision><geometry>" + geometry + "</geometry></collision>") +
              "</link><joint name=\"" + name +
              "\" type=\"fixed\"><parent link=\"root\"/><child link=\"" + name + "\"/></joint>\n";
    }
    return "<robot name=\"m\">\n" + text + "</robot>\n";
  };
  EXPECT_THAT(UrdfMessage(robot(21, 100, "<sphere radius=\"1\"/>")),
              HasSubstr("more than 2000 visuals and collisions in one file"));
  EXPECT_EQ(UrdfMessage(robot(20, 100, "<sphere radius=\"1\"/>")), "(no error)");
  const ScratchFolder folder;
  std::string mesh;
  for (int i = 0; i < 40000; ++i) {
    mesh += "v " + std::to_string(i) + "e-4 0 0\nv 0 " + std::to_string(i) + "e-4 1\nv 0 0 " +
            std::to_string(i) + "e-4\nf -1 -2 -3\n";
  }
  folder.Write("big.obj", mesh);
  const std::string file = folder.Write("m.urdf", robot(1, 40, "<mesh filename=\"big.obj\"/>"));
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder),
              HasSubstr("more than 3 million mesh vertices in one file"));
}

}  // namespace
}  // namespace dockyard
