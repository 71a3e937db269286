#include <cstdarg>
#include <cstdio>

#include "sim/app/drawing.h"

namespace dockyard {
namespace {

__attribute__((format(printf, 1, 2))) std::string Format(const char* format, ...) {
  char text[300];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string Grey(double grey) {
  const int value = static_cast<int>(255.0 * grey + 0.5);
  return Format("rgb(%d,%d,%d)", value, value, value);
}

std::string Escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

struct SvgShape {
  std::string operator()(const DiscShape& s) const {
    return Format("<circle cx=\"%.4f\" cy=\"%.4f\" r=\"%.4f\" fill=\"", s.centre_mm.x(),
                  s.centre_mm.y(), 0.5 * s.diameter_mm) +
           Grey(s.grey) + "\"/>\n";
  }
  std::string operator()(const PolygonShape& s) const {
    std::string text = "<polygon points=\"";
    for (const Eigen::Vector2d& p : s.corners_mm) text += Format("%.4f,%.4f ", p.x(), p.y());
    return text + "\" fill=\"" + Grey(s.grey) + "\"/>\n";
  }
  std::string operator()(const LineShape& s) const {
    return Format(
        "<line x1=\"%.4f\" y1=\"%.4f\" x2=\"%.4f\" y2=\"%.4f\" stroke=\"black\" "
        "stroke-width=\"%.3f\"/>\n",
        s.from_mm.x(), s.from_mm.y(), s.to_mm.x(), s.to_mm.y(), s.line_mm);
  }
  std::string operator()(const TextShape& s) const {
    return Format(
               "<text x=\"%.4f\" y=\"%.4f\" font-family=\"Helvetica,sans-serif\" "
               "font-size=\"%.3f\">",
               s.at_mm.x(), s.at_mm.y(), s.height_mm) +
           Escaped(s.text) + "</text>\n";
  }
};

}  // namespace

std::string SvgText(const Page& page) {
  std::string text = Format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.3fmm\" height=\"%.3fmm\" "
      "viewBox=\"0 0 %.3f %.3f\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      page.width_mm, page.height_mm, page.width_mm, page.height_mm);
  text += Format("<g transform=\"translate(%.4f %.4f)\">\n", page.shift_mm.x(), page.shift_mm.y());
  for (const Shape& shape : page.clipped) text += std::visit(SvgShape{}, shape);
  text += "</g>\n";
  for (const Shape& shape : page.marks) text += std::visit(SvgShape{}, shape);
  return text + "</svg>\n";
}

}  // namespace dockyard
