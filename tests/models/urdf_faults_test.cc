// Every fault of a URDF file at once.
#include <gmock/gmock.h>

#include "models/read/urdf.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> FaultsOf(const std::string& inside) {
  const ScratchFolder folder;
  const std::string file = folder.Write("m.urdf", "<robot name=\"m\">\n" + inside + "</robot>\n");
  std::vector<std::string> faults = FindUrdfFaults(file, {}).faults;
  const std::string path = folder.path().string() + "/";
  for (std::string& fault : faults) {
    for (std::size_t at = 0; (at = fault.find(path)) != std::string::npos;) {
      fault.erase(at, path.size());
    }
  }
  return faults;
}

TEST(UrdfFaults, OfEachLinkAreAllFound) {
  std::string links = "<link name=\"root\"/>\n";
  for (int i = 0; i < 115; ++i) {
    const std::string name = "l" + std::to_string(i);
    links += "<link name=\"" + name +
             "\"><inertial><mass value=\"0\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" "
             "iyz=\"0\" izz=\"1\"/></inertial></link><joint name=\"" +
             name + "\" type=\"fixed\"><parent link=\"root\"/><child link=\"" + name +
             "\"/></joint>\n";
  }
  const std::vector<std::string> faults = FaultsOf(links);
  ASSERT_EQ(faults.size(), 115u);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    EXPECT_THAT(faults[i], StartsWith("m.urdf:" + std::to_string(i + 3) + ":"));
    EXPECT_THAT(faults[i], HasSubstr("'l" + std::to_string(i) + "': mass: "));
  }
}

TEST(UrdfFaults, OfOneLinkNameThePartThatHasThem) {
  EXPECT_THAT(
      FaultsOf("<link name=\"a\">\n"
               "<visual><geometry><mesh filename=\"none.obj\"/></geometry></visual>\n"
               "<visual><geometry><box size=\"1 2\"/></geometry></visual>\n"
               "<visual><geometry><box size=\"1 2 -3\"/></geometry></visual>\n"
               "<visuals/><collision><geometry><sphere radius=\"0\"/></geometry></collision>\n"
               "</link>\n"),
      ElementsAre("m.urdf:3:1: link 'a': mesh filename: expected a file, found none at 'none.obj'",
                  "m.urdf:4:19: <box>: size: expected 3 numbers, found '1 2'",
                  "m.urdf:5:1: link 'a': box size: expected a number > 0, found '-3'",
                  "m.urdf:6:1: <visuals>: unknown element in <link>, did you mean 'visual'?",
                  "m.urdf:6:11: link 'a': sphere radius: expected a number > 0, found '0'"));
}

TEST(UrdfFaults, ThatFollowFromOthersAreNotListed) {
  const std::string joint =
      "<joint name=\"j\" type=\"hinge\"><parent link=\"a\"/>\n<child link=\"x\"/>"
      "<axis xyz=\"0 0 0\"/></joint>\n";
  // Without its joint, b hangs on nothing.
  EXPECT_THAT(FaultsOf("<link name=\"a\"/><link name=\"b\"/>\n" + joint),
              ElementsAre(StartsWith("m.urdf:3:1: <joint>: type: "),
                          "m.urdf:4:1: <child>: expected the name of a link, found 'x'"));
}

TEST(UrdfFaults, OfTheTreeAreListedOnceACircle) {
  const auto joint = [](const std::string& parent, const std::string& child) {
    return "<joint name=\"" + parent + child + "\" type=\"fixed\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/></joint>\n";
  };
  EXPECT_THAT(
      FaultsOf("<link name=\"r\"/><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\n"
               "<link name=\"d\"/>\n" +
               joint("a", "b") + joint("b", "a") + joint("a", "c")),
      ElementsAre("m.urdf:3:1: <link>: 'd' hangs on no joint, expected one tree, its root is "
                  "'r'",
                  "m.urdf:5:1: <joint>: joints in a circle, expected a tree"));
}

TEST(UrdfFaults, AreTheFirstOneWhereTheXmlBreaks) {
  EXPECT_THAT(FaultsOf("<link name=\"a\"><link></robot>"), ElementsAre(HasSubstr("not valid XML")));
}

TEST(UrdfFaults, ThatOnlyLiburdfdomFindsHaveTheirPlace) {
  const std::string joint =
      "<link name=\"a\"/><link name=\"b\"/>\n<joint name=\"j\" type=\"revolute\"><parent "
      "link=\"a\"/>"
      "<child link=\"b\"/><limit lower=\"0\" upper=\"1\" velocity=\"1\"/></joint>\n";
  EXPECT_THAT(FaultsOf(joint), ElementsAre(StartsWith("m.urdf:3:1: not a usable URDF: ")));
  const ScratchFolder folder;
  const std::string file = folder.Write("m.urdf", "<robot name=\"m\">\n" + joint + "</robot>");
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder),
              StartsWith("m.urdf:3:1: not a usable URDF: "));
}

TEST(UrdfFaults, AreNoneInTheModelsHere) {
  for (const char* name : {"axel/axel", "axel/station/station", "raposa/raposa"}) {
    const UrdfFindings found =
        FindUrdfFaults(SourceFile("models/" + std::string(name) + ".urdf"), {});
    EXPECT_THAT(found.faults, ElementsAre()) << name;
  }
}

TEST(UrdfFaults, AreListedWithWhatIsLeftOut) {
  const ScratchFolder folder;
  const std::string file = folder.Write(
      "m.urdf", "<robot name=\"m\"><link name=\"a\" kind=\"x\"/><gazebo/><gazebo/></robot>");
  const UrdfFindings found = FindUrdfFaults(file, {});
  EXPECT_EQ(found.faults.size(), 1u);
  EXPECT_EQ(found.left_out, (std::map<std::string, int>{{"gazebo", 2}}));
}

}  // namespace
}  // namespace dockyard
