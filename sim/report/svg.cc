#include "sim/report/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr const char* kFont = "Helvetica, Arial, 'DejaVu Sans', sans-serif";

std::string Coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", std::clamp(value, -1e6, 1e6) + 0.0);
  return text;
}

bool Drawable(const Px& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

// Points without a place are left out: one bad sample must not spoil the plot.
std::string Points(const std::vector<Px>& points) {
  std::string text;
  for (const Px& p : points) {
    if (!Drawable(p)) continue;
    if (!text.empty()) text += ' ';
    text += Coordinate(p.x) + "," + Coordinate(p.y);
  }
  return text;
}

std::string Stroke(const Pen& pen) {
  std::string text = " stroke=\"" + pen.color + "\" stroke-width=\"" + Coordinate(pen.width) + "\"";
  if (!pen.dash.empty()) text += " stroke-dasharray=\"" + pen.dash + "\"";
  if (pen.opacity < 1.0) text += " stroke-opacity=\"" + Coordinate(pen.opacity) + "\"";
  return text;
}

}  // namespace

std::string XmlText(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

SvgDocument::SvgDocument(double width_px, double height_px, std::string_view title) {
  const std::string w = Coordinate(width_px), h = Coordinate(height_px);
  body_ =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"" +
      w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h + "\" font-family=\"" + kFont +
      "\">\n<title>" + XmlText(title) + "</title>\n";
  Rect({0, 0}, width_px, height_px, "#ffffff");
}

void SvgDocument::OpenGroup(std::string_view css_class, std::string_view id) {
  body_ += "<g class=\"" + XmlText(css_class) + "\"";
  if (!id.empty()) body_ += " id=\"" + XmlText(id) + "\"";
  body_ += ">\n";
  ++open_groups_;
}

void SvgDocument::CloseGroup() {
  DOCKYARD_CHECK(open_groups_ > 0);
  body_ += "</g>\n";
  --open_groups_;
}

void SvgDocument::Line(Px from, Px to, const Pen& pen) {
  if (!Drawable(from) || !Drawable(to)) return;
  body_ += "<line x1=\"" + Coordinate(from.x) + "\" y1=\"" + Coordinate(from.y) + "\" x2=\"" +
           Coordinate(to.x) + "\" y2=\"" + Coordinate(to.y) + "\"" + Stroke(pen) + "/>\n";
}

void SvgDocument::Polyline(const std::vector<Px>& points, const Pen& pen) {
  if (points.empty()) return;
  body_ += "<polyline fill=\"none\" stroke-linejoin=\"round\" points=\"" + Points(points) + "\"" +
           Stroke(pen) + "/>\n";
}

void SvgDocument::Polygon(const std::vector<Px>& points, const std::string& fill, const Pen& pen) {
  body_ +=
      "<polygon fill=\"" + fill + "\" points=\"" + Points(points) + "\"" + Stroke(pen) + "/>\n";
}

void SvgDocument::Circle(Px centre, double radius, const std::string& fill, const Pen& pen) {
  if (!Drawable(centre)) return;
  body_ += "<circle cx=\"" + Coordinate(centre.x) + "\" cy=\"" + Coordinate(centre.y) + "\" r=\"" +
           Coordinate(radius) + "\" fill=\"" + fill + "\"" + Stroke(pen) + "/>\n";
}

void SvgDocument::Rect(Px corner, double width, double height, const std::string& fill,
                       double opacity) {
  body_ += "<rect x=\"" + Coordinate(corner.x) + "\" y=\"" + Coordinate(corner.y) + "\" width=\"" +
           Coordinate(width) + "\" height=\"" + Coordinate(height) + "\" fill=\"" + fill + "\"";
  if (opacity < 1.0) body_ += " fill-opacity=\"" + Coordinate(opacity) + "\"";
  body_ += "/>\n";
}

void SvgDocument::Text(Px at, std::string_view text, const TextStyle& style) {
  const char* anchors[] = {"start", "middle", "end"};
  const std::string x = Coordinate(at.x), y = Coordinate(at.y);
  body_ += "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + Coordinate(style.size) +
           "\" fill=\"" + style.color + "\" text-anchor=\"" +
           anchors[static_cast<int>(style.anchor)] + "\"";
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.turn_deg != 0.0) {
    body_ += " transform=\"rotate(" + Coordinate(style.turn_deg) + " " + x + " " + y + ")\"";
  }
  body_ += ">" + XmlText(text) + "</text>\n";
}

std::string SvgDocument::Finish() {
  DOCKYARD_CHECK(open_groups_ == 0);
  return body_ + "</svg>\n";
}

double NiceStep(double span, int wanted) {
  DOCKYARD_CHECK(span > 0.0 && wanted > 0);
  const double rough = span / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double lead = rough / power;
  return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

std::string TickText(double value, double step) {
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 1e-9 * step ? 0.0 : value);
  return text;
}

DataRange DataRange::Nothing() {
  return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
}

void DataRange::Hold(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

Px PlotArea::At(double x_value, double y_value) const {
  return {corner.x + width * (x_value - x.low) / x.span(),
          corner.y + height * (y.high - y_value) / y.span()};
}

void PlotArea::DrawAxes(SvgDocument& svg, std::string_view x_label, std::string_view y_label,
                        bool x_tick_labels) const {
  const Pen grid{"#e3e3e3", 1.0, "", 1.0}, frame{"#666666", 1.0, "", 1.0};
  const double bottom = corner.y + height, right = corner.x + width;
  const double x_step = NiceStep(x.span(), std::max(2, static_cast<int>(width / 90)));
  for (double i = std::ceil(x.low / x_step - 1e-9); i * x_step <= x.high + 1e-9 * x_step; ++i) {
    const double px = At(i * x_step, y.low).x;
    svg.Line({px, corner.y}, {px, bottom}, grid);
    svg.Line({px, bottom}, {px, bottom + 4}, frame);
    if (x_tick_labels) {
      svg.Text({px, bottom + 17}, TickText(i * x_step, x_step), {11, "#444444", Anchor::kMiddle});
    }
  }
  const double y_step = NiceStep(y.span(), std::max(2, static_cast<int>(height / 40)));
  for (double i = std::ceil(y.low / y_step - 1e-9); i * y_step <= y.high + 1e-9 * y_step; ++i) {
    const double py = At(x.low, i * y_step).y;
    svg.Line({corner.x, py}, {right, py}, grid);
    svg.Line({corner.x - 4, py}, {corner.x, py}, frame);
    svg.Text({corner.x - 8, py + 4}, TickText(i * y_step, y_step), {11, "#444444", Anchor::kEnd});
  }
  svg.Polygon({corner, {right, corner.y}, {right, bottom}, {corner.x, bottom}}, "none", frame);
  svg.Text({corner.x + width / 2, bottom + 36}, x_label, {12, "#222222", Anchor::kMiddle});
  svg.Text({corner.x - 44, corner.y + height / 2}, y_label,
           {12, "#222222", Anchor::kMiddle, false, -90.0});
}

void DrawLegend(SvgDocument& svg, Px at, const std::vector<std::pair<std::string, Pen>>& entries) {
  for (const auto& [word, pen] : entries) {
    svg.Line({at.x, at.y - 4}, {at.x + 22, at.y - 4}, pen);
    svg.Text({at.x + 27, at.y}, word, {11, "#333333"});
    at.x += 27 + 6.2 * static_cast<double>(word.size()) + 16;  // a letter is about 6 px at size 11
  }
}

}  // namespace dockyard
