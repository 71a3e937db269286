#include "models/read/load_cameras.h"

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

#include "models/axel/load_axel.h"
#include "sim/app/systems.h"
#include "sim/axel/load_models.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const std::string kMars = SourceFile("tests/models/data/m2020_cameras.json");
const std::string kNavcam = SourceFile("models/cameras/navcam.yaml");

/// Angle between the rays of two pixels [deg].
double Between(const Camera& camera, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return Degrees(std::acos(camera.Direction(a).dot(camera.Direction(b))));
}

bool Same(const Pose3& a, const Pose3& b) { return a.R == b.R && a.p == b.p; }

struct Field {
  const char* name;
  double across_deg, down_deg;
};

void PrintTo(const Field& field, std::ostream* out) { *out << field.name; }

class MarsCameras : public testing::TestWithParam<Field> {};

TEST_P(MarsCameras, HaveTheirKnownFields) {
  const Camera camera = LoadCamera(kMars, GetParam().name).camera;
  const double u = 0.5 * (camera.width - 1), v = 0.5 * (camera.height - 1);
  EXPECT_NEAR(Between(camera, {0, v}, {2 * u, v}), GetParam().across_deg, 0.05);
  EXPECT_NEAR(Between(camera, {u, 0}, {u, 2 * v}), GetParam().down_deg, 0.05);
}

TEST_P(MarsCameras, ComeBackToTheirPixelsFromNearToFar) {
  const PlacedCamera placed = LoadCamera(kMars, GetParam().name);
  const Camera& camera = placed.camera;
  double worst = 0.0;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const Eigen::Vector2d pixel(camera.width * i / 10.0 - 0.5, camera.height * j / 10.0 - 0.5);
      const LensRay ray = camera.Ray(pixel);
      for (const double range_m : {0.3, 1.0, 5.0, 30.0}) {
        // Through the file's frame and back, as the command line goes.
        const Eigen::Vector3d p_F = placed.X_FC * (ray.origin + range_m * ray.direction);
        const auto back = camera.Project(Inverse(placed.X_FC) * p_F);
        ASSERT_TRUE(back);
        worst = std::max(worst, (*back - pixel).norm());
      }
    }
  }
  EXPECT_LT(worst, 1e-8);
}

// Computed from the published parameters by independent code, one digit after the point.
INSTANTIATE_TEST_SUITE_P(, MarsCameras,
                         testing::Values(Field{"HAZFLA", 128.7, 98.6},
                                         Field{"HELI_NAVCAM", 125.4, 96.3},
                                         Field{"NAVL", 93.6, 71.8}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(MarsPairs, StandTheirBaselinesApart) {
  const auto apart = [](const char* a, const char* b) {
    return (LoadCamera(kMars, a).X_FC.p - LoadCamera(kMars, b).X_FC.p).norm();
  };
  EXPECT_NEAR(apart("HAZFLA", "HAZFRA"), 0.248, 0.0005);
  EXPECT_NEAR(apart("NAVL", "NAVR"), 0.424, 0.0005);
}

// A point given to the file's own equations, by hand: CAHV of the published numbers.
TEST(CameraFile, PointsAreInTheFrameOfItsNumbers) {
  const ScratchFolder folder;
  const std::string file = folder.Write(
      "c.json",
      "{\n\t\"name\": \"SuperCam\", \"type\": \"cahv\", \"frame\": \"Body_RSM_EL\", \"model\": {\n"
      "\t\t\"C\": [-0.174343, -0.111247, -0.216124], \"A\": [0.769672, 0.430839, -0.471152],\n"
      "\t\t\"H\": [196.158204, 50.426507, 79722.473691],\n"
      "\t\t\"V\": [875.629195, 80856.268049, -566.334899],\n"
      "\t\t\"O\": null, \"R\": null, \"E\": null, \"pupilType\": 3, \"linearity\": 0.37,\n"
      "\t\t\"width\": 2048, \"height\": 2048}}\n");
  const PlacedCamera placed = LoadCamera(file);
  EXPECT_EQ(placed.name, "SuperCam");
  const Eigen::Vector3d p_F(5.0, 2.0, -3.0),
      p = p_F - Eigen::Vector3d(-0.174343, -0.111247, -0.216124);
  const double w = p.dot(Eigen::Vector3d(0.769672, 0.430839, -0.471152));
  const auto pixel = placed.camera.Project(Inverse(placed.X_FC) * p_F);
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), p.dot(Eigen::Vector3d(196.158204, 50.426507, 79722.473691)) / w, 1e-7);
  EXPECT_NEAR(pixel->y(), p.dot(Eigen::Vector3d(875.629195, 80856.268049, -566.334899)) / w, 1e-7);
}

TEST(CameraFile, PupilTypesOneAndTwoArePerspectiveAndFisheye) {
  const ScratchFolder folder;
  const auto lens = [&](const std::string& from, const std::string& to) {
    const std::string one = Replaced(Slurp(kMars), "\"pupilType\": 3", from);
    return std::get<Cahvore>(LoadCamera(folder.Write("c.json", one), to).camera.lens);
  };
  EXPECT_EQ(lens("\"pupilType\": 1", "HAZFLA").linearity, 1.0);
  EXPECT_EQ(lens("\"pupilType\": 2", "HAZFLA").linearity, 0.0);
  EXPECT_EQ(lens("\"pupilType\": 3", "HAZFLA").linearity, 0.37);
}

/// The objects of a JSON list, each as its text stands there.
std::vector<std::string> Elements(const std::string& list) {
  std::vector<std::string> elements;
  int depth = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == '{' && depth++ == 0) first = i;
    if (list[i] == '}' && --depth == 0) elements.push_back(list.substr(first, i + 1 - first));
  }
  return elements;
}

TEST(CameraFile, EachOfNasasElementsReadsByItselfAndInCapitals) {
  const ScratchFolder folder;
  const std::vector<PlacedCamera> all = LoadCameras(kMars);
  const std::vector<std::string> elements = Elements(Slurp(kMars));
  ASSERT_EQ(elements.size(), all.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const PlacedCamera one = LoadCamera(folder.Write("c.json", elements[i]));
    const PlacedCamera capital =
        LoadCamera(folder.Write("c.json", Replaced(elements[i], "\"cahvore\"", "\"CAHVORE\"")));
    for (const PlacedCamera* cut : {&one, &capital}) {
      EXPECT_EQ(cut->name, all[i].name);
      EXPECT_TRUE(cut->camera == all[i].camera && Same(cut->X_FC, all[i].X_FC)) << all[i].name;
    }
  }
}

constexpr const char* kWebcam =
    "name: webcam\nmodel: brown\npixel_zero: centre\nwidth_px: 640\nheight_px: 480\n"
    "fx_px: 535.4\nfy_px: 539.1\ncx_px: 320.1\ncy_px: 247.6\nk1: -0.265\nk2: -0.047\np1: 0.0018\n"
    "p2: -0.0003\nk3: 0.252\n";

TEST(CameraFile, WithoutAPlaceIsItsOwnFrame) {
  const ScratchFolder folder;
  const PlacedCamera placed = LoadCamera(folder.Write("c.yaml", kWebcam));
  EXPECT_TRUE(Same(placed.X_FC, Pose3{}));
  EXPECT_EQ(placed.camera.Project({0, 0, 2}), Eigen::Vector2d(320.1, 247.6));
}

TEST(CameraFile, APinholeHasNoDistortionToGive) {
  const ScratchFolder folder;
  const std::string text =
      "model: pinhole\npixel_zero: centre\nwidth_px: 640\nheight_px: 480\nfx_px: 500\n"
      "fy_px: 510\ncx_px: 320\ncy_px: 240\n";
  const PlacedCamera placed = LoadCamera(folder.Write("c.yaml", text));
  const auto pixel = placed.camera.Project({0.4, -0.2, 2.0});
  EXPECT_TRUE(pixel->isApprox(Eigen::Vector2d(320 + 500 * 0.2, 240 - 510 * 0.1), 1e-12));
}

TEST(CameraFile, SaysWhichPointOfTheFirstPixelIsZero) {
  const ScratchFolder folder;
  const auto centre = [&](const char* word) {
    const std::string text =
        Replaced(kWebcam, "pixel_zero: centre", std::string("pixel_zero: ") + word);
    return LoadCamera(folder.Write("c.yaml", text)).camera.centre_px();
  };
  EXPECT_EQ(centre("corner"), Eigen::Vector2d(320.1 - 0.5, 247.6 - 0.5));
  EXPECT_EQ(centre("one"), Eigen::Vector2d(320.1 - 1.0, 247.6 - 1.0));
}

TEST(CameraFile, BadOnesAreToldByPlaceAndPath) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& from, const std::string& to) {
    const std::string file = folder.Write("c.yaml", Replaced(kWebcam, from, to));
    return MessageOf([&] { LoadCamera(file); }, folder);
  };
  EXPECT_EQ(message("fx_px: 535.4", "fx_px: -1"),
            "c.yaml:6:8: fx_px: expected a number > 0, found '-1'");
  EXPECT_EQ(message("k1:", "k_1:"), "c.yaml:10:1: k_1: unknown key, did you mean 'k1'?");
  EXPECT_EQ(message("model: brown", "model: fisheye"),
            "c.yaml:2:8: model: expected one of kannala_brandt, brown, pinhole, rational, "
            "double_sphere, eucm, omni, fov, cahv, cahvor, cahvore, found 'fisheye'");
  EXPECT_THAT(message("model: brown", "model: pinhole"), HasSubstr("c.yaml:10:1: k1: unknown key"));
  EXPECT_EQ(message("pixel_zero: centre\n", ""), "c.yaml:1:1: missing key 'pixel_zero'");
  EXPECT_EQ(message("p1: 0.0018", "yaw_deg: 3"),
            "c.yaml:12:10: yaw_deg: expected a position_m next to it, found '3'");
}

TEST(CameraFile, BadJsonIsToldByPlaceAndPath) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& from, const std::string& to) {
    const std::string file = folder.Write("c.json", Replaced(Slurp(kMars), from, to));
    return MessageOf([&] { LoadCamera(file, "NAVL"); }, folder);
  };
  EXPECT_EQ(message("0.885293,", "0.1,"),
            "c.json:27:9: [0].model.O: expected a vector of length 1 within 0.001, found a list");
  EXPECT_EQ(message("\"pupilType\": 3", "\"pupilType\": 4"),
            "c.json:42:17: [0].model.pupilType: expected a whole number from 1 to 3, found '4'");
  EXPECT_EQ(message("\"NAVL\"", "\"NAVX\""),
            "c.json: expected a camera 'NAVL', found HAZFLA, HAZFRA, HELI_NAVCAM, NAVX, NAVR");
  EXPECT_THAT(message("\"C\": [", "\"C\": 3, \"Q\": ["), HasSubstr("[0].model.Q: unknown key"));
}

TEST(Rig, AxelsFilesAreTheCamerasOfItsModel) {
  for (const int width : {1024, 640}) {
    const StereoRig file =
        LoadRig(SourceFile("models/cameras/axel_" + std::to_string(width) + ".yaml"));
    const StereoRig model =
        axel::LoadRover(SourceFile("models/axel/axel.yaml"), width, width * 3 / 4).stereo.nominal;
    EXPECT_EQ(file.left, model.left);
    EXPECT_EQ(file.right, model.right);
    EXPECT_TRUE(Same(file.X_RL, model.X_RL));
    EXPECT_TRUE(Same(file.X_RQ, model.X_RQ));
  }
}

TEST(Rig, NavcamsLookAheadFromWhereAxelsCamerasStand) {
  const StereoRig rig = LoadRig(kNavcam);
  EXPECT_EQ(rig.left.width, 1024);
  EXPECT_NEAR(rig.baseline_m(), 0.424, 0.0005);
  EXPECT_NEAR(rig.X_RL.p.y(), 0.212, 0.0005);
  EXPECT_NEAR(rig.X_RQ.p.y(), -0.212, 0.0005);
  EXPECT_NEAR(rig.X_RL.p.z(), 0.22, 0.0005);
  EXPECT_GT(rig.X_RL.R(0, 2), 0.9999);   // z ahead
  EXPECT_LT(rig.X_RL.R(1, 0), -0.9999);  // x to the right
  EXPECT_NEAR(rig.left.focal_px().x(), 592.0, 0.5);
}

TEST(Rig, ScalingKeepsTheOuterEdgesOfTheImage) {
  const Camera whole = LoadCamera(kMars, "NAVL").camera;
  const Camera scaled = LoadRig(kNavcam).left;
  for (const Eigen::Vector2d& share : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0.3)}) {
    const auto edge = [&](const Camera& camera) {
      return camera.Ray({share.x() * camera.width - 0.5, share.y() * camera.height - 0.5});
    };
    EXPECT_LT((edge(whole).direction - edge(scaled).direction).norm(), 1e-12);
    EXPECT_LT((edge(whole).origin - edge(scaled).origin).norm(), 1e-12);
  }
}

TEST(Rig, ReplacesTheRoversCamerasFromTheScenarioOrTheRoversFile) {
  const std::string typical = SourceFile("scenarios/axel_typical.yaml");
  const StereoRig navcam = LoadRig(kNavcam);
  const auto rig = [](const Scenario& s) {
    return axel::LoadModels(s).nominal.rover.stereo.nominal;
  };
  const StereoRig chosen =
      rig(LoadScenario(typical, {"camera.file=" + kNavcam}, KnownSystems(Systems())));
  EXPECT_EQ(chosen.left, navcam.left);
  EXPECT_TRUE(Same(chosen.X_RQ, navcam.X_RQ));
  const StereoRig small = rig(LoadScenario(
      typical, {"camera.file=" + kNavcam, "camera.width_px=640", "camera.height_px=480"},
      KnownSystems(Systems())));
  EXPECT_EQ(small.left, Resized(navcam.left, 640, 480));

  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string axel = (folder.path() / "models/axel/axel.yaml").string();
  std::string text = Slurp(axel);
  for (const char* key :
       {"baseline_m", "forward_m", "height_m", "pitch_deg", "field_of_view_deg"}) {
    text = Replaced(text, std::string("\n  ") + key, std::string("\n  # ") + key);
  }
  text = Replaced(text, "cameras:\n", "cameras:\n  file: " + kNavcam + "\n");
  text.resize(text.find("\nspreads:") + 1);  // of numbers that the file no longer has
  const std::string changed = folder.Write("models/axel/axel.yaml", text);
  EXPECT_EQ(axel::LoadRover(changed).stereo.nominal.left, navcam.left);
}

TEST(Rig, BadOnesAreToldByPlaceAndPath) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& from, const std::string& to, int width = 0) {
    const std::string file = folder.Write("r.yaml", Replaced(Slurp(kNavcam), from, to));
    return MessageOf([&] { LoadRig(file, width, width); }, folder);
  };
  EXPECT_EQ(message("R: [0.000002, 0.049535, -0.015973]", "R: [0, -0.5, 0]"),
            "r.yaml:11:3: left: expected a lens that gives every pixel a ray, found none for "
            "'-0.5 -0.5'");
  EXPECT_EQ(message("right:", "rihgt:"), "r.yaml:25:1: rihgt: unknown key, did you mean 'right'?");
  EXPECT_THAT(message("name", "name", 1000),
              HasSubstr("expected a camera of the shape of images of 1000 x 1000"));
  EXPECT_THAT(MessageOf([] { LoadRig(kMars); }, folder), HasSubstr("expected a mapping"));
}

}  // namespace
}  // namespace dockyard
