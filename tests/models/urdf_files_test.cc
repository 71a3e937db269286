// The files that a URDF file names, and those that xacro makes.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "models/read/urdf.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

constexpr char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string Package(const std::string& name) {
  return "<?xml version=\"1.0\"?>\n<package format=\"3\">\n <name> " + name +
         " </name></package>\n";
}

std::string Robot(const std::string& mesh) {
  return "<robot name=\"m\"><link name=\"a\"><visual><geometry><mesh filename=\"" + mesh +
         "\"/></geometry></visual></link></robot>";
}

/// A workspace: src/probe/urdf/m.urdf, with meshes in it and in other packages.
class UrdfPackages : public ::testing::Test {
 protected:
  UrdfPackages() {
    folder_.Write("src/probe/package.xml", "\xEF\xBB\xBF" + Package("probe_description"));
    folder_.Write("src/probe/meshes/body arm.obj", kTriangle);
    folder_.Write("src/other/package.xml", Package("other"));
    folder_.Write("src/other/a.obj", kTriangle);
    folder_.Write("src/group/deep/package.xml", Package("deep"));
    folder_.Write("src/group/deep/a.obj", kTriangle);
    folder_.Write("elsewhere/a.obj", kTriangle);
  }
  std::string MessageFor(const std::string& mesh, const PackageFolders& packages = {}) {
    const std::string file = folder_.Write("src/probe/urdf/x/m.urdf", Robot(mesh));
    return MessageOf([&] { LoadUrdf(file, {.packages = packages}); }, folder_);
  }
  std::string At(const std::string& name) const { return (folder_.path() / name).string(); }

  ScratchFolder folder_;
};

TEST_F(UrdfPackages, AreFoundAboveTheFileAndNextToItsOwn) {
  for (const char* mesh :
       {"package://probe_description/meshes/body arm.obj",
        "package://probe_description/meshes/body%20arm.obj", "package://other/a.obj",
        "package://deep/a.obj", "model://other/a.obj", "../../meshes/body arm.obj"}) {
    EXPECT_EQ(MessageFor(mesh), "(no error)") << mesh;
  }
  EXPECT_EQ(MessageFor("file://" + At("src/probe/meshes/body%20arm.obj")), "(no error)");
  EXPECT_EQ(MessageFor(At("src/probe/meshes/body arm.obj")), "(no error)");
}

TEST_F(UrdfPackages, AreTheOnesThatTheUserNames) {
  EXPECT_EQ(MessageFor("package://mine/a.obj", {{"mine", At("elsewhere")}}), "(no error)");
  EXPECT_THAT(MessageFor("package://other/b.obj", {{"other", At("elsewhere")}}),
              HasSubstr("found none at 'elsewhere/b.obj'"));
}

TEST_F(UrdfPackages, ThatAreNotFoundAreRefusedWithWhatWasSearched) {
  const std::string message = MessageFor("package://nix/a.obj");
  EXPECT_THAT(message, StartsWith("src/probe/urdf/x/m.urdf:1:32: link 'a': mesh filename: expected "
                                  "the ROS package 'nix', found no package.xml of that name in "));
  EXPECT_THAT(message, HasSubstr("two folders deep in 'src/probe', 'src'"));
  EXPECT_THAT(message, HasSubstr("--package nix=DIR"));
}

TEST_F(UrdfPackages, AreNotLeft) {
  EXPECT_THAT(MessageFor("package://other/../../elsewhere/a.obj"), HasSubstr("it leads out of it"));
  EXPECT_THAT(MessageFor("../../../other/a.obj"), HasSubstr("it leads out of it"));
  EXPECT_THAT(MessageFor("file://" + At("elsewhere/a.obj")), HasSubstr("is absolute and leads"));
  EXPECT_THAT(MessageFor("package://other"), HasSubstr("expected package://NAME/PATH"));
  fs::create_symlink(At("elsewhere/a.obj"), At("src/other/link.obj"));
  EXPECT_THAT(MessageFor("package://other/link.obj"), HasSubstr("it leads out of it"));
}

/// A file at that place with that mesh, next to a folder of meshes, without a package.
std::string MessageAt(const std::string& urdf, const std::string& mesh) {
  const ScratchFolder folder;
  folder.Write("robot/meshes/a.obj", kTriangle);
  folder.Write("outside.obj", kTriangle);
  const std::string file = folder.Write(urdf, Robot(mesh));
  return MessageOf([&] { LoadUrdf(file); }, folder);
}

TEST(UrdfWithoutPackage, NamesMeshesNextToAFolderOfUrdfFiles) {
  for (const char* folder : {"urdf", "xacro", "robots"}) {
    const std::string file = std::string("robot/") + folder + "/m.urdf";
    EXPECT_EQ(MessageAt(file, "../meshes/a.obj"), "(no error)") << folder;
    EXPECT_THAT(MessageAt(file, "../../outside.obj"), HasSubstr("it leads out of it")) << folder;
    EXPECT_THAT(MessageAt(file, "/etc/passwd"), HasSubstr("is absolute and leads")) << folder;
    EXPECT_THAT(MessageAt(file, "../meshes/b.obj"), HasSubstr("did you mean")) << folder;
  }
}

TEST(UrdfWithoutPackage, StaysInAFolderOfAnotherName) {
  EXPECT_THAT(MessageAt("robot/drawn/m.urdf", "../meshes/a.obj"),
              HasSubstr("(it leads out of it); a file in a ROS package, or in a folder named urdf, "
                        "xacro or robots, may name meshes next to its folder"));
  EXPECT_THAT(MessageAt("robot/urdf/x/m.urdf", "../../meshes/a.obj"),
              HasSubstr("it leads out of it"));
}

TEST(UrdfWithoutPackage, FollowsNoLinkOutOfTheRobotsFolder) {
  const ScratchFolder folder;
  folder.Write("robot/meshes/a.obj", kTriangle);
  folder.Write("outside.obj", kTriangle);
  fs::create_symlink(folder.path() / "outside.obj", folder.path() / "robot/meshes/link.obj");
  const std::string file = folder.Write("robot/urdf/m.urdf", Robot("../meshes/link.obj"));
  EXPECT_THAT(MessageOf([&] { LoadUrdf(file); }, folder), HasSubstr("it leads out of it"));
}

/// A program of that name first on PATH, as long as it lives.
class OnPath {
 public:
  explicit OnPath(const std::string& script) : before_(std::getenv("PATH")) {
    const std::string file = folder_.Write("xacro", "#!/bin/sh\n" + script);
    fs::permissions(file, fs::perms::owner_all);
    ::setenv("PATH", (folder_.path().string() + ":/usr/bin:/bin").c_str(), 1);
  }
  ~OnPath() { ::setenv("PATH", before_.c_str(), 1); }
  OnPath(const OnPath&) = delete;
  OnPath& operator=(const OnPath&) = delete;

 private:
  ScratchFolder folder_;
  std::string before_;
};

std::string Expanded(const std::string& name, const std::string& text) {
  const ScratchFolder folder;
  folder.Write("a.obj", kTriangle);
  const std::string file = folder.Write(name, text);
  return MessageOf([&] { LoadUrdf(file, {.expand_xacro = true}); }, folder);
}

constexpr char kMacros[] = "<robot name=\"m\">\n<link name=\"${n}\"/></robot>";

TEST(Xacro, IsRunOnFilesWithMacros) {
  const OnPath xacro("sed 's/${n}/a/' \"$1\"");
  EXPECT_EQ(Expanded("m.urdf.xacro", kMacros), "(no error)");
  EXPECT_EQ(Expanded("m.urdf", kMacros), "(no error)");
  // The meshes are in the folder of the file with the macros.
  EXPECT_EQ(Expanded("m.xacro", Robot("a.obj")), "(no error)");
  EXPECT_THAT(Expanded("m.xacro", Robot("b.obj")),
              StartsWith("m.xacro (expanded):1:32: link 'a': mesh filename: expected a file"));
}

TEST(Xacro, IsNotRunOnNotesForOtherPrograms) {
  const OnPath xacro("exit 1");
  EXPECT_EQ(Expanded("m.urdf",
                     "<robot name=\"m\" xmlns:xacro=\"x\"><link name=\"a\"/><gazebo>"
                     "<plugin name=\"$(arg p)\"/></gazebo></robot>"),
            "(no error)");
}

TEST(Xacro, SaysWhatIsWrong) {
  {
    const OnPath xacro("echo half; echo \"undefined n\" >&2; exit 2");
    EXPECT_EQ(Expanded("m.xacro", kMacros), "m.xacro: xacro ended with exit code 2: undefined n");
  }
  const OnPath xacro("cat \"$1\"");
  EXPECT_EQ(Expanded("m.urdf", kMacros), "m.urdf (expanded):2:1: xacro has left '${n}' as it was");
}

TEST(Xacro, IsNamedWhereItIsMissing) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_EQ(Expanded("m.urdf", "<robot name=\"m\">\n<link name=\"$(optenv N a)\"/></robot>"),
            "m.urdf:2:1: '$(optenv N a)' is a macro or an argument: only the program xacro expands "
            "it, and none is on PATH; install it (with ROS: package xacro; without: pip install "
            "xacro), or expand the file by hand: xacro m.urdf > m_expanded.urdf where it is");
  EXPECT_THAT(Expanded("m.urdf.xacro", kMacros), HasSubstr("xacro m.urdf.xacro > m.urdf where"));
  ::setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace dockyard
