// Shapes on paper at true size, as SVG and PDF. Millimetres, x right, y down from the top left.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace dockyard {

struct DiscShape {
  Eigen::Vector2d centre_mm;
  double diameter_mm = 0.0;
  double grey = 0.0;  // 0 black, 1 white
};
struct PolygonShape {
  std::vector<Eigen::Vector2d> corners_mm;
  double grey = 0.0;
};
struct LineShape {
  Eigen::Vector2d from_mm, to_mm;
  double line_mm = 0.1;
};
struct TextShape {
  Eigen::Vector2d at_mm;  // start of the base line
  double height_mm = 3.0;
  std::string text;
};
using Shape = std::variant<DiscShape, PolygonShape, LineShape, TextShape>;

/// A page, and a window to which some of its shapes are clipped.
struct Page {
  double width_mm = 0.0, height_mm = 0.0;
  Eigen::Vector2d window_mm{0, 0}, window_size_mm{0, 0};  // on the page
  Eigen::Vector2d shift_mm{0, 0};                         // of the clipped shapes
  std::vector<Shape> clipped;
  std::vector<Shape> marks;  // over them, neither clipped nor shifted
};

/// One page. Its clipped shapes are shifted, but not clipped.
std::string SvgText(const Page& page);
/// PDF 1.4, uncompressed, its text in Helvetica, which every viewer has.
std::string PdfText(const std::vector<Page>& pages);

}  // namespace dockyard
