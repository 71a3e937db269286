#include <gmock/gmock.h>

#include "controller/geometry/pose.h"
#include "models/axel/load_station.h"
#include "models/parts/board_symmetry.h"
#include "models/read/load_board.h"
#include "sim/app/check_file.h"
#include "sim/app/systems.h"
#include "sim/app/vision_files.h"
#include "sim/axel/load_models.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kPlain =
    "name: p\nkind: plain\nwidth_m: 0.5\nheight_m: 0.5\ndisc_diameter_m: 0.05\n";
const std::string kBars =
    "name: b\nwidth_m: 0.5\nheight_m: 0.5\ndisc_diameter_m: 0.05\nbar_length_m: 0.03\n"
    "bar_width_m: 0.01\nfiducials:\n";

NamedBoard Loaded(const std::string& text) {
  const ScratchFolder folder;
  return LoadBoard(folder.Write("b.yaml", text));
}

std::string Message(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.Write("b.yaml", text);
  return MessageOf([&] { LoadBoard(file); }, folder);
}

std::string Mark(double x, double y, int degrees) {
  return "  - {x_m: " + std::to_string(x) + ", y_m: " + std::to_string(y) +
         ", rotation_deg: " + std::to_string(degrees) + "}\n";
}

TEST(Board, GridRunsRowByRowAboutTheMiddle) {
  const FiducialBoard board =
      Loaded(kPlain + "grid: {columns: 4, rows: 3, pitch_m: 0.09}\nupright_within_deg: 80\n").board;
  ASSERT_EQ(board.fiducials.size(), 12u);
  for (int i = 0; i < 12; ++i) {
    const int column = i % 4, row = i / 4;
    const Eigen::Vector2d wanted(0.09 * column - 0.135, 0.09 * row - 0.09);
    EXPECT_LT((board.fiducials[static_cast<std::size_t>(i)].p_BF - wanted).norm(), 1e-12);
  }
  EXPECT_FALSE(board.HasBars());
  EXPECT_EQ(board.upright.against, Upright::Against::kImage);
  EXPECT_NEAR(Degrees(board.upright.within_rad), 80.0, 1e-12);
}

TEST(Board, StaggeredGridIsOpenCvsAsymmetricOne) {
  // OpenCV's calibration sample: x = (2 j + i % 2) s, y = i s for row i and column j.
  const FiducialBoard board = LoadBoard(SourceFile("models/boards/asymmetric_4x11.yaml")).board;
  ASSERT_EQ(board.fiducials.size(), 44u);
  const double s = 0.02;
  for (int i = 0; i < 11; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Eigen::Vector2d from_first =
          board.fiducials[static_cast<std::size_t>(4 * i + j)].p_BF - board.fiducials[0].p_BF;
      EXPECT_LT((from_first - s * Eigen::Vector2d(2 * j + i % 2, i)).norm(), 1e-12);
    }
  }
}

TEST(Board, FileOfItsOwnAndKeysInAStationGiveTheSame) {
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string station = Slurp(SourceFile("models/axel/station/station.yaml"));
  const std::size_t begin = station.find("board:\n"), end = station.find("\nanchor_depth_m");
  std::string keys = station.substr(begin + 7, end - begin - 7);
  keys = Replaced(keys, "  height_above_axis_m", "  # height_above_axis_m");
  folder.Write("models/board.yaml", "name: own\n" + Replaced(keys, "  width_m", "width_m"));
  // Out of the mapping, by two spaces.
  std::string text = "name: own\n", line;
  std::istringstream lines(keys);
  while (std::getline(lines, line)) text += (line.size() > 2 ? line.substr(2) : line) + "\n";
  folder.Write("models/board.yaml", text);
  const std::string named = folder.Write(
      "models/axel/station/station.yaml",
      station.substr(0, begin) + "board: {file: ../../board.yaml, height_above_axis_m: 0.17}\n" +
          station.substr(end, station.find("\nspreads:") - end) + "\n");
  const axel::StationModel inline_one =
      axel::LoadStation(SourceFile("models/axel/station/station.yaml"));
  const axel::StationModel named_one = axel::LoadStation(named);
  EXPECT_EQ(named_one.board_height_above_axis_m, inline_one.board_height_above_axis_m);
  EXPECT_EQ(named_one.board.bar_length_m, inline_one.board.bar_length_m);
  ASSERT_EQ(named_one.board.fiducials.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(named_one.board.fiducials[i].p_BF, inline_one.board.fiducials[i].p_BF);
    EXPECT_EQ(named_one.board.fiducials[i].rotation, inline_one.board.fiducials[i].rotation);
  }
  const std::vector<System> systems = Systems();
  EXPECT_EQ(BoardOf(named, systems).name, "station");
  EXPECT_TRUE(BoardOf(named, systems).cutout);
  EXPECT_EQ(BoardOf((folder.path() / "models/board.yaml").string(), systems).name, "own");
}

TEST(Board, IsAKindOfFileThatCheckKnows) {
  const FileCheck check = CheckFile(SourceFile("models/boards/grid_4x3.yaml"), Systems());
  EXPECT_EQ(check.kind, "board");
  EXPECT_EQ(check.summary, "grid_4x3: 12 plain discs, 0.36 x 0.255 m");
  EXPECT_EQ(CheckFile(SourceFile("models/boards/five_discs.yaml"), Systems()).summary,
            "five_discs: 5 discs with bars, 0.26 x 0.17 m");
  EXPECT_EQ(CheckFile(SourceFile("models/boards/asymmetric_4x11.yaml"), Systems()).kind, "board");
}

TEST(Board, RefusesAGridThatItsUprightLeavesOpen) {
  const std::string grid = "grid: {columns: 4, rows: 3, pitch_m: 0.09}\n";
  EXPECT_EQ(Message(kPlain + grid + "upright_within_deg: 90\n"),
            "b.yaml:7:21: upright_within_deg: expected less than 90, as a turn by 180 deg maps the "
            "discs onto themselves, found '90'");
  const std::string square = "grid: {columns: 3, rows: 3, pitch_m: 0.09}\n";
  EXPECT_THAT(Message(kPlain + square + "upright_within_deg: 80\n"),
              HasSubstr("expected less than 45, as a turn by 90 deg maps"));
  EXPECT_EQ(Loaded(kPlain + square + "upright_within_deg: 44\n").board.fiducials.size(), 9u);
  EXPECT_THAT(Message(kPlain + grid), HasSubstr("missing key 'upright_within_deg'"));
}

TEST(Board, RefusesBarsThatASymmetryExchanges) {
  // Opposite marks with one bar each: half a turn maps the board onto itself.
  EXPECT_THAT(
      Message(kBars + Mark(-.2, -.2, 0) + Mark(.2, .2, 0) + Mark(.2, -.2, 45) + Mark(-.2, .2, 45)),
      AllOf(StartsWith("b.yaml:8:3: fiducials: expected a layout without symmetry (a turn "
                       "by 180 deg puts 4 marks upon marks with the same bar)")));
  // Other bars break it.
  EXPECT_EQ(
      Loaded(kBars + Mark(-.2, -.2, 0) + Mark(.2, .2, 90) + Mark(.2, -.2, 45) + Mark(-.2, .2, -45))
          .board.fiducials.size(),
      4u);
  // Two rows of three with one bar: five of six would carry a pose one place aside, four do not.
  std::string rows;
  for (int i = 0; i < 6; ++i) rows += Mark(-.2 + 0.08 * i, 0.0, 0);
  EXPECT_THAT(Message(kBars + rows), HasSubstr("puts 6 marks upon marks"));
}

TEST(Board, ShiftOfALatticeIsFound) {
  FiducialBoard board{
      .disc_diameter_m = 0.05, .bar_length_m = 0.03, .bar_width_m = 0.01, .fiducials = {}};
  for (int i = 0; i < 6; ++i) {
    board.fiducials.push_back({.p_BF = {0.1 * i, 0.02 * i * i}, .rotation = 0.0});
  }
  EXPECT_EQ(LargestSymmetry(board, 4, 4.0).marks, 0);  // a parabola has none
  for (Fiducial& mark : board.fiducials) mark.p_BF.y() = 0.0;
  const BoardMotion shift = LargestSymmetry(board, 4, 0.1);  // no half-turn
  EXPECT_EQ(shift.marks, 5);
  EXPECT_NEAR(shift.shift_m.norm(), 0.1, 1e-12);
}

TEST(Board, NoFiveMarksOfTheStationCanBeTakenForOthers) {
  const FiducialBoard board =
      axel::LoadStation(SourceFile("models/axel/station/station.yaml")).board;
  EXPECT_EQ(LargestSymmetry(board, 4, 4.0).marks, 0);
  EXPECT_EQ(MarksNeeded(board), 5);
}

TEST(Board, RefusesKeysOfTheOtherKind) {
  EXPECT_THAT(Message(kPlain + "bar_width_m: 0.01\n"),
              StartsWith("b.yaml:6:14: bar_width_m: expected no bar in a board of kind: plain"));
  EXPECT_THAT(Message("kind: bars\n" + kBars + Mark(0, 0, 0) + "upright_within_deg: 30\n"),
              HasSubstr("upright_within_deg: expected no such key beside kind: bars"));
  EXPECT_THAT(Message(kPlain + "cone: 1\n"), HasSubstr("cone: unknown key"));
  EXPECT_THAT(Message(kPlain + "upright_within_deg: 180\nfiducials:\n  - {x_m: 0, y_m: 0}\n"),
              HasSubstr("expected a list of 6 to 100, found a list of 1"));
  EXPECT_THAT(
      Message(kPlain + "upright_within_deg: 80\ngrid: {columns: 4, rows: 3, pitch_m: 0.058}"),
      HasSubstr("grid: expected white of a fifth of the diameter between plain discs"));
  EXPECT_THAT(Message(kPlain + "upright_within_deg: 80\ngrid: {columns: 4, rows: 3, pitch_m: 0.2}"),
              HasSubstr("grid: expected a disc inside the board, it sticks out"));
}

TEST(Board, Tsai2013WantsTwoBarsOfEachRotation) {
  EXPECT_TRUE(HasTwoOfEachRotation(
      axel::LoadStation(SourceFile("models/axel/station/station.yaml")).board));
  EXPECT_FALSE(HasTwoOfEachRotation(LoadBoard(SourceFile("models/boards/five_discs.yaml")).board));
  const ScratchFolder folder;
  folder.CopyModel("axel");
  const std::string name = "models/axel/station/station.yaml";
  folder.Write(name, Replaced(Slurp(SourceFile(name)), "y_m: 0.17, rotation_deg: 45",
                              "y_m: 0.17, rotation_deg: 90"));
  const std::string change = "axel.station=" + (folder.path() / name).string();
  const std::string scenario = SourceFile("scenarios/axel_typical.yaml");
  axel::LoadModels(LoadScenario(scenario, {change}, KnownSystems(Systems())));
  EXPECT_THAT(
      MessageOf(
          [&] {
            axel::LoadModels(LoadScenario(scenario, {change, "axel.vision.pipeline=tsai2013"},
                                          KnownSystems(Systems())));
          },
          folder),
      HasSubstr("station.yaml: board: expected two bars of each rotation"));
}

}  // namespace
}  // namespace dockyard
