// dockyard board: its printed pages, measured in their raster.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "app/program.h"
#include "controller/geometry/board.h"
#include "controller/geometry/pose.h"
#include "models/read/load_board.h"
#include "support/fake_runs.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double kPxPerMm = 10.0;  // 254 dpi: a pixel is 0.1 mm

/// models/boards/five_discs.yaml, by hand.
FiducialBoard FiveDiscs() {
  FiducialBoard board{.width_m = 0.26,
                      .height_m = 0.17,
                      .disc_diameter_m = 0.04,
                      .bar_length_m = 0.0256,
                      .bar_width_m = 0.0088,
                      .fiducials = {}};
  const double marks[5][3] = {
      {-.1, -.055, 0}, {0, -.06, 45}, {.1, -.05, 90}, {-.085, .055, -45}, {.075, .058, 0}};
  for (const auto& [x, y, degrees] : marks) {
    board.fiducials.push_back({.p_BF = {x, y}, .rotation = Radians(degrees)});
  }
  return board;
}

/// models/boards/asymmetric_4x11.yaml, by OpenCV's formula.
FiducialBoard Asymmetric() {
  FiducialBoard board{
      .width_m = 0.18, .height_m = 0.235, .disc_diameter_m = 0.015, .fiducials = {}};
  for (int i = 0; i < 11; ++i) {
    for (int j = 0; j < 4; ++j) {
      board.fiducials.push_back({.p_BF = {0.02 * (2 * j + i % 2), 0.02 * i}});
    }
  }
  return board;
}

/// The first page as Poppler (PDF) or librsvg (SVG) draws it, grey; empty when they fail.
cv::Mat Rastered(const TemporaryFolder& folder, const std::string& name) {
  const std::string file = (folder.path() / name).string(), png = file + ".png";
  const bool pdf = name.ends_with(".pdf");
  const std::string command = pdf ? "pdftoppm -r 254 -gray -png -singlefile " + file + " " + file
                                  : "rsvg-convert --dpi-x 254 --dpi-y 254 -o " + png + " " + file;
  if (std::system(command.c_str()) != 0) return {};
  return cv::imread(png, cv::IMREAD_GRAYSCALE);
}

struct Blob {
  Eigen::Vector2d centre_mm;
  double width_mm = 0.0, height_mm = 0.0, ink_mm2 = 0.0;
};

/// Dark regions of at least 20 mm^2, by their ink, so that edges count in parts. Lines, which fill
/// little of their box, are left out.
std::vector<Blob> Blobs(const cv::Mat& page) {
  cv::Mat labels, stats, centroids;
  const int count =
      cv::connectedComponentsWithStats(page < 128, labels, stats, centroids, 8, CV_32S);
  std::vector<Blob> blobs;
  for (int i = 1; i < count; ++i) {
    const cv::Rect box(
        stats.at<int>(i, cv::CC_STAT_LEFT) - 2, stats.at<int>(i, cv::CC_STAT_TOP) - 2,
        stats.at<int>(i, cv::CC_STAT_WIDTH) + 4, stats.at<int>(i, cv::CC_STAT_HEIGHT) + 4);
    const int area = stats.at<int>(i, cv::CC_STAT_AREA);
    if (area < 20 * kPxPerMm * kPxPerMm || area < 0.4 * box.area()) continue;
    double ink = 0.0, x = 0.0, y = 0.0;
    for (int v = box.y; v < box.y + box.height; ++v) {
      for (int u = box.x; u < box.x + box.width; ++u) {
        const double dark = 1.0 - page.at<std::uint8_t>(v, u) / 255.0;
        ink += dark;
        x += dark * (u + 0.5);
        y += dark * (v + 0.5);
      }
    }
    blobs.push_back({.centre_mm = Eigen::Vector2d(x, y) / ink / kPxPerMm,
                     .width_mm = (box.width - 4) / kPxPerMm,
                     .height_mm = (box.height - 4) / kPxPerMm,
                     .ink_mm2 = ink / kPxPerMm / kPxPerMm});
  }
  return blobs;
}

/// Discs, and nothing but discs, where the file has them, at their size.
void ExpectBoard(const cv::Mat& page, const FiducialBoard& board) {
  ASSERT_FALSE(page.empty());
  const std::vector<Blob> blobs = Blobs(page);
  ASSERT_EQ(blobs.size(), board.fiducials.size());
  const double d = 1e3 * board.disc_diameter_m;
  const double ink = 0.25 * M_PI * d * d - 1e6 * board.bar_length_m * board.bar_width_m;
  Eigen::Vector2d printed(0, 0), wanted(0, 0);
  for (const Blob& blob : blobs) printed += blob.centre_mm / static_cast<double>(blobs.size());
  for (const Fiducial& mark : board.fiducials)
    wanted += 1e3 * mark.p_BF / static_cast<double>(blobs.size());
  for (const Fiducial& mark : board.fiducials) {
    const Eigen::Vector2d place = 1e3 * mark.p_BF - wanted + printed;
    const auto near = std::min_element(blobs.begin(), blobs.end(), [&](auto& a, auto& b) {
      return (a.centre_mm - place).norm() < (b.centre_mm - place).norm();
    });
    EXPECT_LT((near->centre_mm - place).norm(), 0.05);
    EXPECT_NEAR(near->width_mm, d, 0.21);  // whole pixels, a half of one on either side
    EXPECT_NEAR(near->height_mm, d, 0.21);
    EXPECT_NEAR(near->ink_mm2, ink, 0.003 * ink);  // the diameter to 0.15 %
  }
}

std::string Print(const TemporaryFolder& folder, const std::string& board, const std::string& name,
                  const std::string& more = "") {
  const Ended ended =
      Dockyard("board " + board + " --out " + (folder.path() / name).string() + more);
  EXPECT_EQ(ended.code, 0) << ended.err;
  return ended.out;
}

TEST(BoardCommand, PrintsAtTrueSize) {
  const TemporaryFolder folder;
  for (const std::string board : {"five_discs", "asymmetric_4x11"}) {
    const std::string file = "models/boards/" + board + ".yaml";
    const FiducialBoard wanted = board == "five_discs" ? FiveDiscs() : Asymmetric();
    Print(folder, file, board + ".pdf", " --paper a4");
    const cv::Mat pdf = Rastered(folder, board + ".pdf");
    ExpectBoard(pdf, wanted);
    EXPECT_NEAR(std::max(pdf.cols, pdf.rows), 2970, 1);  // A4
    EXPECT_NEAR(std::min(pdf.cols, pdf.rows), 2100, 1);
    Print(folder, file, board + ".svg");
    ExpectBoard(Rastered(folder, board + ".svg"), wanted);
  }
}

/// Share of ink in a square of the page.
double InkOf(const cv::Mat& page, const Eigen::Vector2d& corner_mm, double side_mm) {
  const auto px = [](double mm) { return static_cast<int>(std::lround(mm * kPxPerMm)); };
  const cv::Rect square(px(corner_mm.x()), px(corner_mm.y()), px(side_mm), px(side_mm));
  return 1.0 - cv::mean(page(square))[0] / 255.0;
}

TEST(BoardCommand, PrintsTheSquaresOfATagAtTrueSize) {
  const TemporaryFolder folder;
  const std::string file = "models/boards/charger_tag.yaml";
  const SquareTag tag = LoadBoard(SourceFile(file)).board.tags[0];
  for (const char* name : {"t.pdf", "t.svg"}) {
    Print(folder, file, name);
    const cv::Mat page = Rastered(folder, name);
    ASSERT_FALSE(page.empty());
    // A board of 160 mm in a page with edges of 8 mm; 0.1 m are eight squares, of ten.
    const Eigen::Vector2d corner_mm = Eigen::Vector2d::Constant(8.0 + 80.0 - 5.0 * 12.5);
    for (int row = 0; row < 10; ++row) {
      for (int column = 0; column < 10; ++column) {
        const double ink = InkOf(page, corner_mm + 12.5 * Eigen::Vector2d(column, row), 12.5);
        // A side that is off by 0.05 mm would take 0.4 % of a square.
        EXPECT_NEAR(ink, tag.cells.IsBlack(column, row) ? 1.0 : 0.0, 0.008)
            << name << ": " << column << ", " << row;
      }
    }
  }
}

TEST(BoardCommand, RuleIsAHundredMillimetres) {
  const TemporaryFolder folder;
  Print(folder, "models/boards/five_discs.yaml", "b.pdf");
  const cv::Mat page = Rastered(folder, "b.pdf");
  ASSERT_FALSE(page.empty());
  // Below the board, the one row of ink that is 100 mm long.
  int longest = 0;
  for (int v = static_cast<int>((8.0 + 170.0 + 2.0) * kPxPerMm); v < page.rows; ++v) {
    int run = 0;
    for (int u = 0; u < page.cols; ++u) {
      run = page.at<std::uint8_t>(v, u) < 128 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(longest / kPxPerMm, 100.0, 0.31);  // and the width of the end ticks, 0.2 mm
}

TEST(BoardCommand, DetectFindsThePrint) {
  // Through a pinhole facing the page squarely: 10 px a mm at 1 m are f = 10 000 px, here halved.
  const TemporaryFolder folder;
  Print(folder, "models/boards/five_discs.yaml", "b.pdf");
  cv::Mat page = Rastered(folder, "b.pdf"), seen;
  ASSERT_FALSE(page.empty());
  cv::resize(page, seen, cv::Size(page.cols / 10, page.rows / 10), 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(seen, seen, cv::Size(0, 0), 0.6);
  cv::copyMakeBorder(seen, seen, 100, 100, 200, 200, cv::BORDER_CONSTANT, cv::Scalar(110));
  const std::string image = (folder.path() / "seen.png").string();
  cv::imwrite(image, seen);
  const std::string w = std::to_string(seen.cols), h = std::to_string(seen.rows);
  const std::string camera =
      "model: brown, pixel_zero: centre, width_px: " + w + ", height_px: " + h +
      ", fx_px: 1000, fy_px: 1000, cx_px: " + std::to_string(0.5 * (seen.cols - 1)) +
      ", cy_px: " + std::to_string(0.5 * (seen.rows - 1)) + ", k1: 0, k2: 0, k3: 0, p1: 0, p2: 0";
  WriteText(folder.path() / "rig.yaml", "left: {" + camera + ", position_m: [0, 0, 0]}\nright: {" +
                                            camera + ", position_m: [0, -0.1, 0]}\n");
  const Ended ended =
      Dockyard("detect " + image + " --rig " + (folder.path() / "rig.yaml").string() +
               " --board models/boards/five_discs.yaml --json");
  ASSERT_EQ(ended.code, 0) << ended.err << ended.out;
  const json out = json::parse(ended.out);
  EXPECT_EQ(out["detected_left"], 5);
  // 1 px a mm at f = 1000 px is 1 m ahead; the board's middle 9.5 mm above the page's.
  EXPECT_NEAR(out["board_in_rover"]["p_m"][0].get<double>(), 1.0, 0.002);
  EXPECT_NEAR(out["board_in_rover"]["p_m"][1].get<double>(), 0.0, 0.0005);
  EXPECT_NEAR(out["board_in_rover"]["p_m"][2].get<double>(), 0.0095, 0.0005);
}

TEST(BoardCommand, TilesAreThePartsOfOneBoard) {
  const TemporaryFolder folder;
  const std::string out =
      Print(folder, "models/axel/station/station.yaml", "b.pdf", " --paper a3 --tile");
  EXPECT_THAT(out, HasSubstr("station, 6 pages of 420 x 297 mm"));
  const std::string file = (folder.path() / "b.pdf").string();
  ASSERT_EQ(std::system(("pdftoppm -r 25.4 -gray -png " + file + " " + file).c_str()), 0);
  // 1 px a mm: 404 x 281 mm of each page, laid edge to edge.
  double ink = 0.0;
  for (int i = 1; i <= 6; ++i) {
    const cv::Mat page = cv::imread(file + "-" + std::to_string(i) + ".png", cv::IMREAD_GRAYSCALE);
    ASSERT_NEAR(page.cols, 420, 1);
    ASSERT_NEAR(page.rows, 297, 1);
    const cv::Mat window = page(cv::Rect(10, 10, 400, 277));  // within the frame's line
    ink += cv::sum(255 - window)[0] / 255.0;
  }
  const double discs = 8 * (0.25 * M_PI * 100 * 100 - 64 * 22);
  EXPECT_GT(ink, 0.97 * discs);
  EXPECT_LT(ink, 1.05 * discs);  // outline, cut-out, rule and text
}

TEST(BoardCommand, RefusesWhatItCannotPrint) {
  const std::string station = "board models/axel/station/station.yaml --out /tmp/none";
  const Ended paper = Dockyard(station + ".pdf --paper a3");
  EXPECT_EQ(paper.code, 2);
  EXPECT_THAT(paper.err, HasSubstr("expected a paper that holds 900 x 519 mm within edges of 8 mm "
                                   "(the smallest: a0), or --tile"));
  EXPECT_THAT(Dockyard(station + ".svg --paper a4 --tile").err,
              HasSubstr("expected a file .pdf for"));
  EXPECT_THAT(Dockyard(station + ".png").err, HasSubstr("expected a file .svg or .pdf"));
  EXPECT_EQ(Dockyard(station + ".pdf --tile").code, 2);
  EXPECT_EQ(Dockyard(station + ".pdf --paper b5").code, 2);
  EXPECT_EQ(Dockyard("board models/axel/axel.yaml --out /tmp/none.pdf").code, 3);
}

}  // namespace
}  // namespace dockyard
