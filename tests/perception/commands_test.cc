// dockyard detect and dockyard pose, run from the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "app/program.h"
#include "controller/geometry/camera.h"
#include "sim/base/json.h"
#include "sim/images/png.h"
#include "sim/log/frame_codec.h"
#include "support/fake_runs.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string kFiles =
    " --robot models/axel/axel.yaml --board models/axel/station/station.yaml";

std::string PointsCsv(const std::string& last_row) {
  // Corners of a cube of 0.4 m, 2 m ahead of the pair, by the nominal rig.
  Pose3 X_RC;  // models/axel/axel.yaml: 0.35 m apart, 0.12 m ahead, 0.22 m up, level
  X_RC.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Camera camera = EquidistantCamera(1024, 768, Radians(90.0));
  std::string csv = "camera,u_px,v_px,x_m,y_m,z_m\n";
  const Pose3 X_RB{RotZ(0.2), {2.2, 0.1, 0.3}};
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d p_B(i & 1 ? 0.2 : -0.2, i & 2 ? 0.2 : -0.2, i & 4 ? 0.2 : -0.2);
    for (const bool right : {false, true}) {
      X_RC.p = {0.12, right ? -0.175 : 0.175, 0.22};
      const auto pixel = camera.Project(Inverse(X_RC) * X_RB * p_B);
      char row[200];
      std::snprintf(row, sizeof row, "%s,%.6f,%.6f,%.3f,%.3f,%.3f\n", right ? "right" : "left",
                    pixel->x(), pixel->y(), p_B.x(), p_B.y(), p_B.z());
      csv += row;
    }
  }
  return csv + last_row;
}

TEST(DetectCommand, FindsTheBoardOfARenderedPair) {
  const TemporaryFolder folder;
  const std::string out_dir = folder.path().string();
  ASSERT_EQ(Dockyard("view scenarios/axel_typical.yaml --set start.r_m=2.5 --set "
                     "camera.width_px=640 --set camera.height_px=480 --out " +
                     out_dir)
                .code,
            0);
  const json view = json::parse(Slurp(folder.path() / "view.json"));
  const std::string left = out_dir + "/left.png", right = out_dir + "/right.png";
  const std::string drawn = out_dir + "/drawn.png";
  const Ended ended = Dockyard("detect " + left + " " + right + kFiles + " --json --draw " + drawn);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const json out = json::parse(ended.out);
  EXPECT_EQ(out["accepted"], true);
  EXPECT_EQ(out["method"], "stereo");
  const json& pose = out["board_in_rover"];
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(pose["p_m"][i].get<double>(), view["X_RB"]["p_m"][i].get<double>(), 0.03);
  double norm = 0.0;
  for (const json& q : pose["quaternion_wxyz"]) norm += q.get<double>() * q.get<double>();
  EXPECT_NEAR(norm, 1.0, 1e-9);
  EXPECT_EQ(pose["covariance"].size(), 6u);
  EXPECT_EQ(out["fiducials"].size(), 16u);
  EXPECT_GT(std::filesystem::file_size(drawn), 10000u);
  // The right image alone, named as such.
  const json alone =
      json::parse(Dockyard("detect " + right + " --camera right --json" + kFiles).out);
  EXPECT_EQ(alone["accepted"], true);
  EXPECT_EQ(alone["method"], "right");
  EXPECT_EQ(alone["detected_left"], 0);
  EXPECT_TRUE(alone["warnings"].empty());
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(alone["board_in_rover"]["p_m"][i].get<double>(),
                view["X_RB"]["p_m"][i].get<double>(), 0.05);
  }
  EXPECT_EQ(Dockyard("detect " + left + " " + right + " --camera right" + kFiles).code, 2);
  EXPECT_EQ(Dockyard("detect " + left + " --camera middle" + kFiles).code, 2);
  // Upside down.
  const TemporaryFolder others;
  const std::string turned = (others.path() / "turned.png").string();
  cv::Mat image = cv::imread(left, cv::IMREAD_GRAYSCALE), flipped;
  cv::flip(image, flipped, -1);
  cv::imwrite(turned, flipped);
  const Ended upside_down = Dockyard("detect " + turned + kFiles);
  EXPECT_EQ(upside_down.code, 4);
  EXPECT_THAT(upside_down.err,
              HasSubstr("turned by 180 deg the left image shows the board: is it upside down?"));
  // A JPEG that lost its end, and one that did not.
  const std::string jpeg = (others.path() / "whole.jpg").string();
  cv::imwrite(jpeg, image);
  EXPECT_EQ(Dockyard("detect " + jpeg + kFiles).err, "");
  const std::string bytes = Slurp(jpeg);
  WriteText(others.path() / "cut.jpg", bytes.substr(0, bytes.size() * 9 / 10));
  EXPECT_THAT(Dockyard("detect " + (others.path() / "cut.jpg").string() + kFiles).err,
              HasSubstr("cut.jpg: expected a whole JPEG, found one without its end"));
  const Ended folder_run = Dockyard("detect --folder " + folder.path().string() + kFiles);
  EXPECT_EQ(folder_run.code, 0);
  const Ended nowhere = Dockyard("detect --folder " + folder.path().string() + "/none" + kFiles);
  EXPECT_EQ(nowhere.code, 3);
  EXPECT_THAT(nowhere.err, HasSubstr("none: expected a folder of images"));
  EXPECT_THAT(folder_run.out, HasSubstr("3 images"));
}

/// A point of the dock in the robot's frame, by the truth that `view` wrote into a folder.
Eigen::Vector3d InRobot(const TemporaryFolder& folder, const Eigen::Vector3d& p_DB) {
  const Json truth = Json::parse(Slurp((folder.path() / "truth.json").string()));
  return Inverse(Pose3FromJson(truth["X_DR"])) * p_DB;
}

const std::string kCharger = " --robot examples/docks/charger/robot/robot.yaml";

TEST(DetectCommand, FindsTheBoardByACameraThatTheRobotsFileNames) {
  const std::string dock = " --board examples/docks/charger/dock/dock.yaml";
  const TemporaryFolder folder;
  const std::string view = "view examples/docks/charger/scenario.yaml --out ";
  ASSERT_EQ(Dockyard(view + folder.path().string()).code, 0);
  const std::string front = (folder.path() / "front.png").string();
  const json out =
      json::parse(Dockyard("detect " + front + " --camera front --json" + kCharger + dock).out);
  EXPECT_EQ(out["accepted"], true);
  EXPECT_EQ(out["method"], "front");
  EXPECT_EQ(out["fiducials"][0]["camera"], "front");
  const Eigen::Vector3d p_R = InRobot(folder, {-0.055, 0.0, 0.20});
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(out["board_in_rover"]["p_m"][i].get<double>(), p_R[i], 0.03);
  // The first camera is the default; another name is refused with those that there are.
  EXPECT_EQ(Dockyard("detect " + front + kCharger + dock).code, 0);
  const Ended other = Dockyard("detect " + front + " --camera frnt" + kCharger + dock);
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("expected a camera 'frnt' in the list 'cameras', found none, "
                                   "did you mean 'front'?"));
  const Ended pair = Dockyard("detect " + front + " " + front + kCharger + dock);
  EXPECT_EQ(pair.code, 3);
  EXPECT_THAT(pair.err, HasSubstr("expected a camera 'left' in the list 'cameras'"));
}

TEST(DetectCommand, FindsDiscsByACameraThatTheRobotsFileNames) {
  const std::string board = "models/boards/grid_4x3.yaml";
  const TemporaryFolder folder;
  const std::string boards =
      "[{name: discs, file: " + SourceFile(board) + ", link: dock, middle_m: [-0.055, 0, 0.25]}]";
  ASSERT_EQ(Dockyard("view examples/docks/charger/scenario.yaml --out " + folder.path().string() +
                     " --set 'changes={dock: {boards: " + boards + "}}'")
                .code,
            0);
  const json out = json::parse(Dockyard("detect " + (folder.path() / "front.png").string() +
                                        " --json" + kCharger + " --board " + board)
                                   .out);
  EXPECT_EQ(out["accepted"], true);
  EXPECT_EQ(out["board_discs"], 12);
  const Eigen::Vector3d p_R = InRobot(folder, {-0.055, 0.0, 0.25});
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(out["board_in_rover"]["p_m"][i].get<double>(), p_R[i], 0.03);
}

TEST(DetectCommand, SaysWhyThereIsNoBoard) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "grey.png").string();
  WriteText(file,
            EncodePng(GrayImage{
                .width = 64, .height = 48, .pixels = std::vector<std::uint8_t>(64 * 48, 90)}));
  const Ended ended = Dockyard("detect " + file + kFiles);
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.out, HasSubstr("no board: too few fiducials"));
}

TEST(DetectCommand, RefusesWhatIsNoImage) {
  EXPECT_EQ(Dockyard("detect README.md" + kFiles).code, 3);
  EXPECT_EQ(Dockyard("detect missing.png" + kFiles).code, 3);
  EXPECT_EQ(Dockyard("detect" + kFiles).code, 2);
}

TEST(DetectCommand, NamesTheFilesOfAFolderThatAreNoImagesAndGoesOn) {
  const TemporaryFolder folder;
  const auto grey = [](int width, int height) {
    return EncodePng(GrayImage{
        .width = width, .height = height, .pixels = std::vector<std::uint8_t>(width * height, 90)});
  };
  const std::string dir = folder.path().string();
  EXPECT_EQ(Dockyard("detect --folder " + dir + kFiles).code, 3);  // empty
  WriteText(folder.path() / "a.png", "no image");
  WriteText(folder.path() / "b.png", grey(64, 48));
  WriteText(folder.path() / "c.png", grey(48, 64));
  std::filesystem::create_directory(folder.path() / "d.png");
  const Ended ended = Dockyard("detect --folder " + dir + kFiles);
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("a.png: expected an image"));
  EXPECT_THAT(ended.out, HasSubstr("2 images, 0 boards accepted; 1 not usable"));
  // These cameras have one aspect ratio; the upright image has another.
  const Ended navcam = Dockyard("detect --json --folder " + dir +
                                " --rig models/cameras/navcam.yaml "
                                "--board models/axel/station/station.yaml");
  EXPECT_EQ(navcam.code, 3);
  const json out = json::parse(navcam.out);
  EXPECT_EQ(out["images"], 1);
  EXPECT_EQ(out["not_looked_at"], 2);
  EXPECT_THAT(out["files"][2]["error"].get<std::string>(), HasSubstr("48 x 64"));
  // A bad rig is reported once.
  const Ended bad = Dockyard("detect --folder " + dir +
                             " --rig README.md --board models/axel/station/station.yaml");
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, HasSubstr("README.md"));
  EXPECT_EQ(bad.out, "");
}

TEST(DetectCommand, RefusesOptionsThatWouldDoNothing) {
  const Ended points = Dockyard("detect x.png --min-points 5" + kFiles);
  EXPECT_EQ(points.code, 2);
  EXPECT_THAT(points.err, HasSubstr("--min-points is a choice of --pipeline tsai2013"));
  EXPECT_EQ(Dockyard("pose x.csv --min-points 5 --robot models/axel/axel.yaml").code, 2);
  EXPECT_EQ(Dockyard("detect x.png --min-points 5 --pipeline tsai2013" + kFiles).code, 3);
  EXPECT_EQ(Dockyard("detect --folder . --draw x.png" + kFiles).code, 2);
}

TEST(PoseCommand, SolvesPointsAndNamesTheOutlier) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "points.csv").string();
  WriteText(file, PointsCsv("left,100,100,0.2,0.2,0.2\n"));
  const Ended ended = Dockyard("pose " + file + " --robot models/axel/axel.yaml --json");
  ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
  const json out = json::parse(ended.out);
  EXPECT_EQ(out["points_used"], 16);
  EXPECT_EQ(out["inlier"].back(), false);
  const double expected[3] = {2.2, 0.1, 0.3};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(out["body_in_rover"]["p_m"][i].get<double>(), expected[i], 1e-4);
  }
  EXPECT_NEAR(out["body_in_rover"]["quaternion_wxyz"][0].get<double>(), std::cos(0.1), 1e-4);
}

/// PointsCsv with a first column `frame` and an unknown last one.
std::string FramesCsv(const std::string& second_frame) {
  std::string csv;
  for (std::size_t begin = 0, row = 0; begin < PointsCsv("").size(); ++row) {
    const std::string all = PointsCsv("");
    const std::size_t end = all.find('\n', begin);
    csv += (row == 0 ? "frame," : "late,") + all.substr(begin, end - begin) +
           (row == 0 ? ",tag\n" : ",7\n");
    begin = end + 1;
  }
  return csv + second_frame;
}

TEST(PoseCommand, ASequenceGivesOneObjectAFrameInOrderOfAppearance) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "frames.csv").string();
  WriteText(file, FramesCsv("1,left,100,100,0.2,0.2,0.2,\n1,left,120,100,0.2,-0.2,0.2,9\n"));
  const std::string command = "pose --robot models/axel/axel.yaml --sequence " + file;
  const Ended ended = Dockyard(command + " --json");
  ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
  std::istringstream lines(ended.out);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const json late = json::parse(line);
  EXPECT_EQ(late["frame"], "late");
  EXPECT_EQ(late["points_used"], 16);
  const double here[3] = {2.2, 0.1, 0.3};  // turned by 0.2 about z
  const double back[3] = {-2.2 * std::cos(0.2) - 0.1 * std::sin(0.2),
                          2.2 * std::sin(0.2) - 0.1 * std::cos(0.2), -0.3};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(late["body_in_rover"]["p_m"][i].get<double>(), here[i], 1e-4);
    EXPECT_NEAR(late["rover_in_body"]["p_m"][i].get<double>(), back[i], 1e-4);
  }
  EXPECT_GT(late["rover_in_body"]["covariance"][0][0].get<double>(), 0.0);
  EXPECT_LT(late["chi_square"].get<double>(), 1.0);
  EXPECT_EQ(late["freedom"], 26);
  ASSERT_TRUE(std::getline(lines, line));
  const json second = json::parse(line);
  EXPECT_EQ(second["frame"], "1");
  EXPECT_EQ(second["accepted"], false);
  EXPECT_EQ(second["reason"], "too few fiducials");
  EXPECT_FALSE(std::getline(lines, line));

  const Ended table = Dockyard(command + " --csv");
  ASSERT_EQ(table.code, 0);
  std::istringstream rows(table.out);
  std::vector<long> commas;
  while (std::getline(rows, line)) commas.push_back(std::count(line.begin(), line.end(), ','));
  EXPECT_THAT(commas, testing::ElementsAre(37, 37, 37));
}

TEST(PoseCommand, SaysWhatAFileOfFramesMustHave) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "points.csv").string();
  const std::string rig = " --robot models/axel/axel.yaml";
  WriteText(file, PointsCsv(""));
  const Ended without = Dockyard("pose --sequence " + file + rig);
  EXPECT_EQ(without.code, 3);
  EXPECT_THAT(without.err, HasSubstr("missing key 'frame'"));
  EXPECT_EQ(Dockyard("pose " + file + " --sequence " + file + rig).code, 2);
  EXPECT_EQ(Dockyard("pose" + rig).code, 2);
  EXPECT_EQ(Dockyard("pose " + file + rig + " --survey-error-m 0.01 --pipeline tsai2013").code, 2);
  WriteText(file, FramesCsv("1,left,100,100,0.2,0.2,0.2,\n"));
  const Ended several = Dockyard("pose " + file + rig);
  EXPECT_EQ(several.code, 3);
  EXPECT_THAT(several.err, HasSubstr("points.csv:18:1: row 17.frame: expected the same frame"));
  WriteText(file, "camera,u_px,v_px,x_m,y_m,z_m,survey_eror_m\nleft,1,2,0,0,0,1\n");
  const Ended slip = Dockyard("pose " + file + rig);
  EXPECT_EQ(slip.code, 3);
  EXPECT_THAT(slip.err, HasSubstr("points.csv:1:30: survey_eror_m: unknown column, did you mean"));
  for (const auto& [header, meant] :
       {std::pair("Camera,u_px,v_px,x_m,y_m,z_m",
                  "1:1: Camera: unknown column, did you mean 'camera'?"),
        std::pair("camera,u_px,v_px,x_m,y_m,z_mm",
                  "1:26: z_mm: unknown column, did you mean 'z_m'?"),
        std::pair("camera,u_px,v_px,x_m,y_m,z_m,Frame",
                  "1:30: Frame: unknown column, did you mean 'frame'?")}) {
    WriteText(file, std::string(header) + "\nleft,1,2,0,0,0" +
                        (std::string(header).ends_with("Frame") ? ",1\n" : "\n"));
    EXPECT_THAT(Dockyard("pose " + file + rig).err, HasSubstr(meant)) << header;
  }
  WriteText(file, "frame,camera,u_px,v_px,x_m,y_m,z_m\na,left,1,2,0,0,0\n");
  EXPECT_EQ(Dockyard("pose --sequence " + file + rig).code, 4);
}

TEST(PoseCommand, NoticesThatLeftAndRightAreExchanged) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "points.csv").string();
  std::string csv = PointsCsv("");
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = csv.find(from, at)) != std::string::npos; at += to.size()) {
      csv.replace(at, from.size(), to);
    }
  };
  rename("left", "other");
  rename("right", "left");
  rename("other", "right");
  WriteText(file, csv);
  const Ended ended = Dockyard("pose " + file + " --robot models/axel/axel.yaml");
  EXPECT_EQ(ended.code, 4);
  const std::string mistake = "with left and right exchanged the points agree";
  EXPECT_THAT(ended.out, HasSubstr(mistake));
  // A table has no column for it.
  const Ended table = Dockyard("pose " + file + " --robot models/axel/axel.yaml --csv");
  EXPECT_THAT(table.err, HasSubstr("no pose: cameras disagree: "));
  EXPECT_THAT(table.err, HasSubstr(mistake));
  std::string frames = "frame," + csv.substr(0, csv.find('\n') + 1);
  for (const char* name : {"a,", "b,"}) {
    for (std::size_t at = csv.find('\n') + 1; at < csv.size(); at = csv.find('\n', at) + 1) {
      frames += name + csv.substr(at, csv.find('\n', at) + 1 - at);
    }
  }
  WriteText(file, frames);
  for (const char* form : {" --csv", " --json", ""}) {
    const Ended many =
        Dockyard("pose --sequence " + file + " --robot models/axel/axel.yaml" + form);
    EXPECT_THAT(many.err, HasSubstr("warning: 2 of 2 frames have no pose: " + mistake)) << form;
  }
}

TEST(PoseCommand, TakesTheImagesSizeFromTheRigAndTheSurveysErrorFromItsColumn) {
  // A rectified pair in the left camera's frame, as docs/reference/cameras.md writes it, not of 4
  // to 3.
  const TemporaryFolder folder;
  const std::string rig = (folder.path() / "rig.yaml").string();
  const std::string file = (folder.path() / "points.csv").string();
  const std::string camera =
      "model: pinhole, pixel_zero: centre, width_px: 1920, height_px: 1080, fx_px: 1000, fy_px: "
      "1000, cx_px: 960, cy_px: 540";
  WriteText(rig, "left: {" + camera + "}\nright: {" + camera +
                     ", position_m: [0.12, 0, 0], pitch_deg: -90, roll_deg: 90}\n");
  const auto write = [&](const char* survey) {
    std::string csv = "camera,u_px,v_px,x_m,y_m,z_m,survey_error_m\n";
    for (int i = 0; i < 8; ++i) {
      const double x = i & 1 ? 0.5 : -0.5, y = i & 2 ? 0.4 : -0.4, z = i & 4 ? 0.3 : -0.3;
      for (const double at : {0.0, 0.12}) {
        char row[200];
        std::snprintf(row, sizeof row, "%s,%.6f,%.6f,%.2f,%.2f,%.2f,%s\n",
                      at > 0.0 ? "right" : "left", 960 + 1000 * (x - at) / (z + 3.0),
                      540 + 1000 * y / (z + 3.0), x, y, z, survey);
        csv += row;
      }
    }
    WriteText(file, csv);
    const Ended ended = Dockyard("pose " + file + " --json --rig " + rig);
    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    return json::parse(ended.out);
  };
  const json exact = write("0"), empty = write(""), coarse = write("0.05");
  const double expected[3] = {0.0, 0.0, 3.0};
  const auto variance = [](const json& out) {
    return out["body_in_rover"]["covariance"][2][2].get<double>();
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(exact["body_in_rover"]["p_m"][i].get<double>(), expected[i], 1e-5);
  }
  EXPECT_NEAR(empty["survey_error_m"].get<double>(), 0.001, 1e-12);  // of 1 m
  EXPECT_LT(variance(exact), variance(coarse));
  EXPECT_LT(variance(empty), variance(coarse));
}

TEST(PoseCommand, NamesTheRowThatIsWrong) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "points.csv").string();
  WriteText(file, PointsCsv("middle,100,100,0.2,0.2,0.2\n"));
  const Ended ended = Dockyard("pose " + file + " --robot models/axel/axel.yaml");
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("points.csv:18:1"));
  EXPECT_THAT(ended.err, HasSubstr("camera"));
}

TEST(PoseCommand, EndsWithFourWhenTooFewAgree) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "points.csv").string();
  WriteText(file, "camera,u_px,v_px,x_m,y_m,z_m\nleft,1,2,0,0,0\nleft,5,9,1,0,0\n");
  const Ended ended = Dockyard("pose " + file + " --robot models/axel/axel.yaml");
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.out, HasSubstr("no pose"));
}

}  // namespace
}  // namespace dockyard::axel
