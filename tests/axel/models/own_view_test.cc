// What the rover has of itself before its cameras, at all places that its file allows.
#include "models/axel/own_view.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "models/axel/load_axel.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/yaml_path.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kFiles{"models/axel/axel.yaml", "models/axel/axel_coaxial.yaml"};

YamlNode Tree(const std::vector<std::string>& sets) {
  YamlNode tree = ParseYaml("{}", "scenario.yaml");
  for (const std::string& set : sets) SetYaml(tree, set);
  return tree;
}

RoverModel With(const std::string& file, const std::vector<std::string>& sets,
                MeshStore* meshes = nullptr) {
  const YamlNode tree = Tree(sets);
  return LoadRover(SourceFile(file), 640, 480, {.nominal = &tree}, meshes);
}

double LargestShare(const RoverModel& rover) {
  const StereoRig& rig = rover.stereo.nominal;
  return std::max(ShareOfOwnBody(rover, rig.left, rig.X_RL),
                  ShareOfOwnBody(rover, rig.right, rig.X_RQ));
}

/// The ends of what the file says that the number may be.
std::vector<std::string> EndsOf(const std::string& file, const std::string& key) {
  for (const NumberSpread& spread : ReadSpreads(LoadModelYaml(SourceFile(file)))) {
    if (spread.key.name != key) continue;
    return {key + "=" + NumberText(spread.assumed->low),
            key + "=" + NumberText(spread.assumed->high)};
  }
  ADD_FAILURE() << file << " has no spread of " << key;
  return {};
}

/// Box of a visual's vertices on one side of the body.
Eigen::AlignedBox3d HalfOf(const RoverModel& rover, const char* name, bool left) {
  Eigen::AlignedBox3d box;
  for (const Visual& visual : rover.body.visuals) {
    if (visual.name != name) continue;
    for (const Eigen::Vector3d& v : visual.mesh->vertices) {
      const Eigen::Vector3d p_R = visual.X_LV * v;
      if ((p_R.y() > 0.0) == left) box.extend(p_R);
    }
  }
  return box;
}

const Collision& PartOf(const RoverModel& rover, const std::string& name) {
  for (const Collision& part : rover.body.collisions) {
    if (part.name == name) return part;
  }
  throw std::out_of_range(name);
}

TEST(OwnView, IsClearOfTheRoverInItsFiles) {
  for (const std::string& file : kFiles) EXPECT_EQ(LargestShare(With(file, {})), 0.0) << file;
}

// Together, as a campaign draws them: the corners of the box of all three numbers.
TEST(OwnView, IsNotBlindAtAnyCornerOfWhatTheFilesDeclare) {
  MeshStore meshes;
  for (const std::string& file : kFiles) {
    for (const std::string& forward : EndsOf(file, "cameras.forward_m")) {
      for (const std::string& height : EndsOf(file, "cameras.height_m")) {
        for (const std::string& wheels : EndsOf(file, "wheels.radius_m")) {
          for (const std::string& track : EndsOf(file, "wheels.track_m")) {
            const double share =
                LargestShare(With(file, {forward, height, wheels, track}, &meshes));
            // The most: of the widest wheels on the narrowest track, next to a camera.
            EXPECT_LT(share, 0.35) << file << " " << forward << " " << height << " " << wheels;
          }
        }
      }
    }
  }
}

TEST(CameraHeads, FollowTheirCameras) {
  const RoverModel drawn = With(kFiles[0], {});
  const RoverModel moved = With(
      kFiles[0], {"cameras.forward_m=0.02", "cameras.height_m=0.28", "cameras.baseline_m=0.41"});
  for (const bool left : {true, false}) {
    const Eigen::Vector3d shift(-0.10, left ? 0.03 : -0.03, 0.06);
    const StereoRig &was = drawn.stereo.nominal, &is = moved.stereo.nominal;
    EXPECT_LT(((left ? is.X_RL.p - was.X_RL.p : is.X_RQ.p - was.X_RQ.p) - shift).norm(), 1e-12);
    const auto before = HalfOf(drawn, "camera_heads", left),
               after = HalfOf(moved, "camera_heads", left);
    EXPECT_LT((after.min() - before.min() - shift).norm(), 1e-12);
    EXPECT_LT((after.max() - before.max() - shift).norm(), 1e-12);
    EXPECT_LT(after.max().x(), (left ? is.X_RL : is.X_RQ).p.x());  // the lens is the foremost
    const auto post_before = HalfOf(drawn, "camera_posts", left),
               post_after = HalfOf(moved, "camera_posts", left);
    EXPECT_LT((post_after.max() - post_before.max() - shift).norm(), 1e-12);
    EXPECT_EQ(post_after.min().z(), post_before.min().z());  // in the housing
    const char* part = left ? "left_head" : "right_head";
    EXPECT_LT((PartOf(moved, part).X_LG.p - PartOf(drawn, part).X_LG.p - shift).norm(), 1e-12);
  }
  EXPECT_EQ(moved.body.p_LoCom_L, drawn.body.p_LoCom_L);
  EXPECT_EQ(PartOf(moved, "housing").X_LG.p, PartOf(drawn, "housing").X_LG.p);
}

TEST(CameraHeads, StayWhereTheCamerasDo) {
  const RoverModel drawn = With(kFiles[0], {}), same = With(kFiles[0], {"cameras.forward_m=0.12"});
  EXPECT_EQ(HalfOf(same, "camera_heads", true).max(), HalfOf(drawn, "camera_heads", true).max());
}

// The same cameras with the heads left where they were drawn have their own heads before them.
TEST(OwnView, IsBlindInsideAHeadThatStays) {
  const RoverModel moved = With(kFiles[0], {"cameras.forward_m=0.07"});
  EXPECT_LT(LargestShare(moved), 0.05);
  RoverModel stayed = moved;
  stayed.body = With(kFiles[0], {}).body;
  EXPECT_GT(LargestShare(stayed), 0.9);
  EXPECT_THAT(BlindedBy(stayed), HasSubstr(" % of the left image"));
}

TEST(OwnView, OfCamerasInTheHousingIsRefusedWithTheKeysPlace) {
  const ScratchFolder folder;
  EXPECT_THAT(MessageOf(
                  [] {
                    With(kFiles[0], {"cameras.forward_m=0", "cameras.height_m=0.05"});
                  },
                  folder),
              HasSubstr("cameras.forward_m: expected cameras with at most half of an image filled "
                        "by the rover's own body, found 100 % of the left image"));
  const YamlNode built = Tree({"cameras.mounting.z_m=-0.25", "cameras.mounting.x_m=-0.15"});
  EXPECT_THAT(
      MessageOf([&] { LoadRover(SourceFile(kFiles[0]), 640, 480, {.built = &built}); }, folder),
      HasSubstr("filled by the rover's own body"));
}

}  // namespace
}  // namespace dockyard::axel
