// A small SVG writer: shapes in pixels, and plot areas that map data to them.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dockyard {

/// A place on the page, x right, y down [px].
struct Px {
  double x = 0.0, y = 0.0;
};

struct Pen {
  std::string color = "#000000";
  double width = 1.0;  // [px]
  std::string dash;    // as in SVG, "6 3"
  double opacity = 1.0;
};

enum class Anchor { kStart, kMiddle, kEnd };
struct TextStyle {
  double size = 12.0;  // [px]
  std::string color = "#222222";
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  double turn_deg = 0.0;  // clockwise about the anchor point
};

class SvgDocument {
 public:
  SvgDocument(double width_px, double height_px, std::string_view title);

  void OpenGroup(std::string_view css_class, std::string_view id = "");
  void CloseGroup();
  void Line(Px from, Px to, const Pen& pen);
  void Polyline(const std::vector<Px>& points, const Pen& pen);
  /// fill "none" for an outline.
  void Polygon(const std::vector<Px>& points, const std::string& fill, const Pen& pen);
  void Circle(Px centre, double radius, const std::string& fill, const Pen& pen);
  void Rect(Px corner, double width, double height, const std::string& fill, double opacity = 1.0);
  void Text(Px at, std::string_view text, const TextStyle& style = {});
  /// The whole file; all groups must be closed.
  std::string Finish();

 private:
  std::string body_;
  int open_groups_ = 0;
};

/// Text with &, <, > and quotes escaped, control characters left out.
std::string XmlText(std::string_view text);

/// A number as tick labels want it: no more decimals than the step needs.
std::string TickText(double value, double step);
/// 1, 2 or 5 times a power of ten, so that about `wanted` steps cover the span.
double NiceStep(double span, int wanted);

struct DataRange {
  double low = 0.0, high = 1.0;
  /// Grows to hold the value; NaN and infinity are ignored.
  void Hold(double value);
  double span() const { return high - low; }
  /// Empty: grows from the first value on.
  static DataRange Nothing();
  bool empty() const { return !(low <= high); }
};

/// A rectangle of the page with a data range on each side.
struct PlotArea {
  Px corner;  // top left
  double width = 0.0, height = 0.0;
  DataRange x, y;

  Px At(double x_value, double y_value) const;
  /// Frame, grid lines, ticks and labels with units.
  void DrawAxes(SvgDocument& svg, std::string_view x_label, std::string_view y_label,
                bool x_tick_labels = true) const;
};

/// Legend entries beside each other: a line in its pen and a word, from `at` to the right.
void DrawLegend(SvgDocument& svg, Px at, const std::vector<std::pair<std::string, Pen>>& entries);

}  // namespace dockyard
