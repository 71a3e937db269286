// `dockyard stereo` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "app/program.h"
#include "sim/base/json.h"
#include "sim/images/png.h"
#include "stereo/ray_scene.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

// The file of the body pair of ray_scene.h.
std::string RigText() {
  const StereoRig rig = BodyPair();
  std::ostringstream text;
  text.precision(17);
  text << "name: body_pair\nsource: test\n";
  for (const bool right : {false, true}) {
    const Camera& camera = right ? rig.right : rig.left;
    text << (right ? "right" : "left") << ":\n  model: kannala_brandt\n  pixel_zero: centre\n"
         << "  width_px: " << camera.width << "\n  height_px: " << camera.height
         << "\n  fx_px: " << camera.focal_px().x() << "\n  fy_px: " << camera.focal_px().y()
         << "\n  cx_px: " << camera.centre_px().x() << "\n  cy_px: " << camera.centre_px().y()
         << "\n  k: [0, 0, 0, 0]\n  position_m: [0, " << (right ? -0.05 : 0.05)
         << ", 0.3]\n  pitch_deg: 45\n";
  }
  return text.str();
}

class StereoCommand : public ::testing::Test {
 protected:
  StereoCommand() {
    RayScene scene;
    scene.stone = {0.45, 0.03, 0.008};
    scene.stone_radius_m = 0.025;
    const StereoImages images = scene.Pair(BodyPair());
    left_ = folder_.Write("left.png", EncodePng(images.left));
    right_ = folder_.Write("right.png", EncodePng(images.right));
    rig_ = folder_.Write("rig.yaml", RigText());
  }
  std::string Arguments() const { return left_ + " " + right_ + " --rig " + rig_; }

  ScratchFolder folder_;
  std::string left_, right_, rig_;
};

TEST_F(StereoCommand, WritesHeightsAndDisparitiesOfAUsersPictures) {
  const std::string heights = folder_.path() / "heights.csv";
  const std::string disparity = folder_.path() / "disparity.png";
  // The rig's frame has its origin on the ground.
  const Ended ended = Dockyard("stereo " + Arguments() + " --ground 0.001 --json --elevation " +
                               heights + " --disparity " + disparity);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json json = Json::parse(ended.out);
  EXPECT_NEAR(json["baseline_m"].get<double>(), 0.1, 1e-9);
  EXPECT_GT(json["matched_share"].get<double>(), 0.5);
  std::istringstream rows(Slurp(heights));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "x_m,y_m,height_m,sigma_m,points");
  double highest_m = 0.0;
  while (std::getline(rows, row)) {
    double x = 0, y = 0, height = 0;
    ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf", &x, &y, &height), 3);
    if (std::hypot(x - 0.45, y - 0.03) < 0.08) highest_m = std::max(highest_m, height);
  }
  EXPECT_NEAR(highest_m, 0.033, 6e-3);
  EXPECT_THAT(Slurp(disparity), HasSubstr("PNG"));
}

TEST_F(StereoCommand, RefusesWhatIsNoPair) {
  EXPECT_EQ(Dockyard("stereo " + left_ + " " + right_).code, 2);
  for (const char* wrong :
       {"--block 4", "--block 3 --matcher blocks", "--reach 100 --cell 0.001"}) {
    EXPECT_EQ(Dockyard("stereo " + Arguments() + " " + wrong).code, 2) << wrong;
  }
  const GrayImage small{8, 6, std::vector<std::uint8_t>(48, 9)};
  const std::string other = folder_.Write("small.png", EncodePng(small));
  const Ended ended = Dockyard("stereo " + left_ + " " + other + " --rig " + rig_);
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("expected an image of 320 x 240 pixels"));
}

}  // namespace
}  // namespace dockyard
