#include "sim/app/board_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/app/commands.h"
#include "sim/app/tag_outline.h"

namespace dockyard {
namespace {

constexpr double kEdge_mm = 8.0;     // of a paper, where printers do not print: 4 to 6 mm
constexpr double kFooter_mm = 19.0;  // below the board: rule and two lines of text
constexpr double kLeast_mm = 125.0;  // width of the footer

struct Paper {
  const char* name;
  double width_mm, height_mm;
};
constexpr std::array<Paper, 6> kPapers{{{"a4", 210.0, 297.0},  // ISO 216
                                        {"a3", 297.0, 420.0},
                                        {"a2", 420.0, 594.0},
                                        {"a1", 594.0, 841.0},
                                        {"a0", 841.0, 1189.0},
                                        {"letter", 215.9, 279.4}}};  // ANSI A

/// To a hundredth.
std::string Millimetres(double metres) { return NumberText(std::round(1e5 * metres) / 100.0); }

struct Sketch {
  double width_mm = 0.0, height_mm = 0.0;
  std::vector<Shape> shapes;  // from its own top left corner
};

void AddMark(const FiducialBoard& board, const Fiducial& mark, const Eigen::Vector2d& middle_mm,
             Sketch& sketch) {
  const Eigen::Vector2d centre = middle_mm + 1e3 * mark.p_BF;
  sketch.shapes.push_back(
      DiscShape{.centre_mm = centre, .diameter_mm = 1e3 * board.disc_diameter_m});
  if (!board.HasBars()) return;
  const Eigen::Vector2d along(std::cos(mark.rotation), -std::sin(mark.rotation));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d a = 500.0 * board.bar_length_m * along,
                        b = 500.0 * board.bar_width_m * across;
  sketch.shapes.push_back(PolygonShape{
      .corners_mm = {centre + a + b, centre + a - b, centre - a - b, centre - a + b}, .grey = 1.0});
}

/// Its squares as outlines, so that no seam shows between two.
void AddTag(const SquareTag& tag, const Eigen::Vector2d& middle_mm, Sketch& sketch) {
  for (const TagOutline& outline : OutlinesOf(tag.cells)) {
    PolygonShape shape{.corners_mm = {}, .grey = outline.black ? 0.0 : 1.0};
    for (const Eigen::Vector2i& corner : outline.corners) {
      const Eigen::Vector2d cell =
          corner.cast<double>() - Eigen::Vector2d::Constant(0.5 * tag.cells.across);
      shape.corners_mm.push_back(middle_mm + 1e3 * OnBoard(tag, tag.cell_m() * cell));
    }
    sketch.shapes.push_back(shape);
  }
}

void AddFrame(const Eigen::Vector2d& from_mm, const Eigen::Vector2d& size_mm,
              std::vector<Shape>& shapes) {
  const Eigen::Vector2d x(size_mm.x(), 0.0), y(0.0, size_mm.y());
  shapes.push_back(LineShape{.from_mm = from_mm, .to_mm = from_mm + x});
  shapes.push_back(LineShape{.from_mm = from_mm + x, .to_mm = from_mm + x + y});
  shapes.push_back(LineShape{.from_mm = from_mm + x + y, .to_mm = from_mm + y});
  shapes.push_back(LineShape{.from_mm = from_mm + y, .to_mm = from_mm});
}

/// The part of a station's cut-out that lies on the board.
void AddCutout(const BoardCutout& cutout, const Eigen::Vector2d& middle_mm,
               const Eigen::Vector2d& corner_mm, const Eigen::Vector2d& size_mm, Sketch& sketch) {
  constexpr int kSteps = 360;
  const auto at = [&](int i) {
    const double angle = 2.0 * kPi * i / kSteps;
    return Eigen::Vector2d(middle_mm + 1e3 * cutout.p_B +
                           1e3 * cutout.radius_m *
                               Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  const auto on_board = [&](const Eigen::Vector2d& p) {
    return (p.array() >= corner_mm.array()).all() &&
           (p.array() <= (corner_mm + size_mm).array()).all();
  };
  for (int i = 0; i < kSteps; ++i) {
    if (!on_board(at(i)) || !on_board(at(i + 1))) continue;
    sketch.shapes.push_back(LineShape{.from_mm = at(i), .to_mm = at(i + 1)});
  }
}

std::string MarksText(const FiducialBoard& board) {
  if (board.tags.empty()) {
    return std::to_string(board.fiducials.size()) + " discs of " +
           Millimetres(board.disc_diameter_m) + " mm" + (board.HasBars() ? " with bars" : "");
  }
  std::string text = board.tags.size() == 1 ? "tag " : "tags ";
  constexpr std::size_t kMostNamed = 4;  // more do not fit on the line
  for (std::size_t i = 0; i < std::min(kMostNamed, board.tags.size()); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(board.tags[i].id);
  }
  if (board.tags.size() > kMostNamed) text += ", ...";
  return text + " of " + board.tags[0].family + ", " + Millimetres(board.tags[0].size_m) + " mm";
}

/// 100 mm with a tick at each centimetre, and the instruction for it.
void AddFooter(const NamedBoard& named, double top_mm, Sketch& sketch) {
  const double y = top_mm + 6.0, x = 1.0;
  sketch.shapes.push_back(LineShape{.from_mm = {x, y}, .to_mm = {x + 100.0, y}, .line_mm = 0.2});
  for (int i = 0; i <= 10; ++i) {
    const double tick = i % 5 == 0 ? 2.5 : 1.5;
    sketch.shapes.push_back(
        LineShape{.from_mm = {x + 10.0 * i, y - tick}, .to_mm = {x + 10.0 * i, y}, .line_mm = 0.2});
  }
  const FiducialBoard& board = named.board;
  sketch.shapes.push_back(TextShape{.at_mm = {x + 103.0, y}, .text = "100 mm"});
  sketch.shapes.push_back(
      TextShape{.at_mm = {x, y + 5.0},
                .text = "Print at 100 %, not fitted to the page; the rule above must be 100 mm."});
  sketch.shapes.push_back(TextShape{.at_mm = {x, y + 9.5},
                                    .text = named.name + ": " + Millimetres(board.width_m) + " x " +
                                            Millimetres(board.height_m) + " mm, " +
                                            MarksText(board)});
}

Sketch SketchOf(const NamedBoard& named) {
  const FiducialBoard& board = named.board;
  const Eigen::Vector2d size_mm(1e3 * board.width_m, 1e3 * board.height_m);
  Sketch sketch{.width_mm = std::max(size_mm.x(), kLeast_mm),
                .height_mm = size_mm.y() + kFooter_mm,
                .shapes = {}};
  const Eigen::Vector2d corner(0.5 * (sketch.width_mm - size_mm.x()), 0.0);
  const Eigen::Vector2d middle = corner + 0.5 * size_mm;
  for (const Fiducial& mark : board.fiducials) AddMark(board, mark, middle, sketch);
  for (const SquareTag& tag : board.tags) AddTag(tag, middle, sketch);
  AddFrame(corner, size_mm, sketch.shapes);
  if (named.cutout) AddCutout(*named.cutout, middle, corner, size_mm, sketch);
  AddFooter(named, size_mm.y(), sketch);
  return sketch;
}

/// All of it in the middle of one page.
Page Whole(const Sketch& sketch, double width_mm, double height_mm) {
  return {.width_mm = width_mm,
          .height_mm = height_mm,
          .window_mm = {0.0, 0.0},
          .window_size_mm = {width_mm, height_mm},
          .shift_mm = {0.5 * (width_mm - sketch.width_mm), 0.5 * (height_mm - sketch.height_mm)},
          .clipped = sketch.shapes,
          .marks = {}};
}

std::vector<Page> Tiles(const Sketch& sketch, double width_mm, double height_mm) {
  const Eigen::Vector2d window(width_mm - 2.0 * kEdge_mm, height_mm - 2.0 * kEdge_mm);
  const int columns = static_cast<int>(std::ceil(sketch.width_mm / window.x() - 1e-9));
  const int rows = static_cast<int>(std::ceil(sketch.height_mm / window.y() - 1e-9));
  std::vector<Page> pages;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d edge(kEdge_mm, kEdge_mm);
      Page page{.width_mm = width_mm,
                .height_mm = height_mm,
                .window_mm = edge,
                .window_size_mm = window,
                .shift_mm = edge - Eigen::Vector2d(column * window.x(), row * window.y()),
                .clipped = sketch.shapes,
                .marks = {}};
      AddFrame(edge, window, page.marks);
      page.marks.push_back(
          TextShape{.at_mm = {kEdge_mm, kEdge_mm - 1.5},
                    .text = "row " + std::to_string(row + 1) + " of " + std::to_string(rows) +
                            ", column " + std::to_string(column + 1) + " of " +
                            std::to_string(columns) + ": cut along the frame, lay edge to edge"});
      pages.push_back(std::move(page));
    }
  }
  return pages;
}

bool Fits(const Sketch& sketch, double width_mm, double height_mm) {
  return sketch.width_mm <= width_mm - 2.0 * kEdge_mm + 1e-9 &&
         sketch.height_mm <= height_mm - 2.0 * kEdge_mm + 1e-9;
}

/// Upright when it fits so.
std::optional<Page> OnOne(const Sketch& sketch, const Paper& paper) {
  if (Fits(sketch, paper.width_mm, paper.height_mm)) {
    return Whole(sketch, paper.width_mm, paper.height_mm);
  }
  if (Fits(sketch, paper.height_mm, paper.width_mm)) {
    return Whole(sketch, paper.height_mm, paper.width_mm);
  }
  return std::nullopt;
}

[[noreturn]] void RefusePaper(const Sketch& sketch, const std::string& name) {
  std::string holds = "none";
  for (const Paper& paper : kPapers) {
    if (!OnOne(sketch, paper)) continue;
    holds = paper.name;
    break;
  }
  const auto mm = [](double length) { return NumberText(std::round(10.0 * length) / 10.0); };
  throw UsageError("--paper " + name + ": expected a paper that holds " + mm(sketch.width_mm) +
                   " x " + mm(sketch.height_mm) + " mm within edges of " + mm(kEdge_mm) +
                   " mm (the smallest: " + holds + "), or --tile");
}

}  // namespace

std::vector<std::string> PaperNames() {
  std::vector<std::string> names;
  for (const Paper& paper : kPapers) names.push_back(paper.name);
  return names;
}

std::vector<Page> BoardPages(const NamedBoard& named, const std::optional<std::string>& paper,
                             bool tile) {
  const Sketch sketch = SketchOf(named);
  if (!paper) {
    return {Whole(sketch, sketch.width_mm + 2.0 * kEdge_mm, sketch.height_mm + 2.0 * kEdge_mm)};
  }
  const Paper& chosen = *std::find_if(kPapers.begin(), kPapers.end(),
                                      [&](const Paper& p) { return *paper == p.name; });
  if (const auto page = OnOne(sketch, chosen)) return {*page};
  if (!tile) RefusePaper(sketch, *paper);
  const std::vector<Page> upright = Tiles(sketch, chosen.width_mm, chosen.height_mm);
  const std::vector<Page> across = Tiles(sketch, chosen.height_mm, chosen.width_mm);
  return across.size() < upright.size() ? across : upright;
}

}  // namespace dockyard
