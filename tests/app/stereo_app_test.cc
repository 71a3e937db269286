// `dockyard stereo` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
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
  for (const char* wrong : {"--disparity x.tif", "--block 4", "--block 3 --matcher blocks",
                            "--reach 100 --cell 0.001"}) {
    EXPECT_EQ(Dockyard("stereo " + Arguments() + " " + wrong).code, 2) << wrong;
  }
  const GrayImage small{8, 6, std::vector<std::uint8_t>(48, 9)};
  const std::string other = folder_.Write("small.png", EncodePng(small));
  const Ended ended = Dockyard("stereo " + left_ + " " + other + " --rig " + rig_);
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("expected an image of 320 x 240 pixels"));
}

TEST_F(StereoCommand, SaysThatAPairIsOneAndWhyAnotherIsNone) {
  const auto Warnings = [&](const std::string& left, const std::string& right) {
    const Ended ended = Dockyard("stereo " + left + " " + right + " --rig " + rig_ + " --json");
    EXPECT_EQ(ended.code, 0) << ended.err;
    const Json warnings = Json::parse(ended.out)["warnings"];
    EXPECT_EQ(warnings.empty(), ended.err.empty());
    return warnings.dump();
  };
  EXPECT_EQ(Warnings(left_, right_), "[]");
  EXPECT_THAT(Warnings(right_, left_), HasSubstr("exchanged"));
  EXPECT_THAT(Warnings(left_, left_), HasSubstr("the same image"));
  const GrayImage right = *DecodePng<GrayImage>(Slurp(right_));
  GrayImage lower = right, turned = right;
  std::copy(right.pixels.begin(), right.pixels.end() - 3 * 320, lower.pixels.begin() + 3 * 320);
  std::reverse(turned.pixels.begin(), turned.pixels.end());
  EXPECT_THAT(Warnings(left_, folder_.Write("lower.png", EncodePng(lower))),
              HasSubstr("rows lower"));
  EXPECT_THAT(Warnings(left_, folder_.Write("turned.png", EncodePng(turned))),
              HasSubstr("upside down"));
  StereoRig elsewhere = BodyPair();
  elsewhere.X_RQ.p.x() += 5.0;
  const std::string other = folder_.Write("other.png", EncodePng(RayScene{}.Pair(elsewhere).right));
  EXPECT_THAT(Warnings(left_, other), HasSubstr("two different scenes"));
}

// What a user needs to make points of the disparities himself.
TEST_F(StereoCommand, GivesTheRectifiedCamera) {
  const Ended ended = Dockyard("stereo " + Arguments() + " --json");
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json["principal_point_px"].size(), 2u);
  EXPECT_NEAR(json["rotation_left_wxyz"][0].get<double>(), 1.0, 1e-12);  // parallel cameras
  EXPECT_EQ(json["Q"][0][3], -json["principal_point_px"][0].get<double>());
  EXPECT_EQ(json["Q"][2][3], json["focal_px"]);
  EXPECT_NEAR(json["Q"][3][2].get<double>(), 10.0, 1e-6);
  EXPECT_EQ(json["kept_as_it_was"], false);  // equidistant lenses
}

TEST_F(StereoCommand, WritesPointsInTheRigsFrame) {
  const std::string file = folder_.path() / "points.ply";
  ASSERT_EQ(Dockyard("stereo " + Arguments() + " --points " + file).code, 0);
  const std::string ply = Slurp(file);
  std::size_t count = 0;
  ASSERT_EQ(std::sscanf(ply.c_str() + ply.find("element vertex"), "element vertex %zu", &count), 1);
  const std::size_t begin = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), begin + 15 * count);
  ASSERT_GT(count, 10000u);
  std::size_t on_ground = 0;
  for (std::size_t i = 0; i < count; ++i) {
    float z = 0.0F;
    std::memcpy(&z, ply.data() + begin + 15 * i + 8, sizeof z);
    on_ground += std::abs(z) < 0.02F;
  }
  EXPECT_GT(static_cast<double>(on_ground), 0.9 * static_cast<double>(count));
}

// Its own disparities as the truth: all there, none off by more than a file's rounding.
TEST_F(StereoCommand, ScoresAPairByTrueDisparities) {
  for (const char* name : {"d.pfm", "d.png"}) {
    const std::string file = folder_.path() / name;
    ASSERT_EQ(Dockyard("stereo " + Arguments() + " --disparity " + file).code, 0);
    const Ended ended = Dockyard("stereo " + Arguments() + " --json --truth " + file);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const Json truth = Json::parse(ended.out)["truth"];
    EXPECT_EQ(truth["density"], 1.0);
    EXPECT_EQ(truth["bad_1px_share"], 0.0);
    EXPECT_LT(truth["rms_px"].get<double>(), 0.5 / 256.0);
    EXPECT_THAT(Dockyard("stereo " + Arguments() + " --truth " + file).out, HasSubstr("100.0 %"));
  }
  const Ended other = Dockyard("stereo " + Arguments() + " --truth " + left_);
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("the size of the left rectified image"));
}

TEST_F(StereoCommand, SaysThatATruthOfNoPixelScoresNothing) {
  const std::string file = folder_.path() / "d.pfm";
  ASSERT_EQ(Dockyard("stereo " + Arguments() + " --disparity " + file).code, 0);
  std::string text = Slurp(file);
  // Infinity in every pixel: three lines of text precede them.
  std::size_t begin = 0;
  for (int line = 0; line < 3; ++line) begin = text.find('\n', begin) + 1;
  for (std::size_t i = begin; i < text.size(); ++i) text[i] = "\0\0\x80\x7f"[(i - begin) % 4];
  std::ofstream(file, std::ios::binary) << text;
  const Ended ended = Dockyard("stereo " + Arguments() + " --json --truth " + file);
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(Json::parse(ended.out)["warnings"].dump(),
              HasSubstr("no pixel has a true disparity"));
}

// OpenCV ends a program for some of these.
TEST_F(StereoCommand, TakesOrRefusesImagesOfAnySizeInASentence) {
  const auto Small = [&](int width, int height, const std::string& more) {
    GrayImage left{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
      left.pixels.push_back(static_cast<std::uint8_t>(HashDouble(3, i) >> 56));
    }
    GrayImage right = left;
    const int shift = std::min(4, width * height - 1);
    std::rotate(right.pixels.begin(), right.pixels.begin() + shift, right.pixels.end());
    const std::string lens =
        "{model: pinhole, pixel_zero: centre, width_px: " + std::to_string(width) +
        ", height_px: " + std::to_string(height) +
        ", fx_px: 100, fy_px: 100, cx_px: 1, cy_px: 1, position_m: [0, ";
    const std::string rig =
        folder_.Write("small.yaml", "left: " + lens + "0.1, 0]}\nright: " + lens + "0, 0]}\n");
    return Dockyard("stereo " + folder_.Write("l.png", EncodePng(left)) + " " +
                    folder_.Write("r.png", EncodePng(right)) + " --rig " + rig + more);
  };
  EXPECT_EQ(Small(64, 48, "").code, 0);
  EXPECT_EQ(Small(128, 40, " --matcher blocks").code, 0);
  EXPECT_EQ(Small(22, 6, "").code, 0);
  for (const char* more : {" --block 63", " --disparities 64", " --disparities 1024",
                           " --matcher blocks --block 21"}) {
    const Ended ended = Small(65, 20, more);
    EXPECT_EQ(ended.code, 2) << more;
    EXPECT_THAT(ended.err, HasSubstr("needs rectified images of at least")) << more;
  }
  for (const int side : {1, 4, 20}) {
    const Ended ended = Small(side, side, "");
    EXPECT_EQ(ended.code, 3) << side;
    EXPECT_THAT(ended.err, HasSubstr("16 disparities"));
  }
}

}  // namespace
}  // namespace dockyard
