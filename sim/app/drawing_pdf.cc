#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "controller/geometry/pose.h"
#include "sim/app/drawing.h"

namespace dockyard {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;

__attribute__((format(printf, 1, 2))) std::string Format(const char* format, ...) {
  char text[300];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

/// Bezier curves through eight points: off the circle by 4e-6 of the radius at most.
std::string CirclePath(const Eigen::Vector2d& centre, double radius) {
  constexpr int kArcs = 8;
  const double step = 2.0 * kPi / kArcs;
  const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * radius;
  const auto at = [&](int i) {
    return Eigen::Vector2d(centre +
                           radius * Eigen::Vector2d(std::cos(i * step), std::sin(i * step)));
  };
  const auto along = [&](int i) {
    return Eigen::Vector2d(handle * Eigen::Vector2d(-std::sin(i * step), std::cos(i * step)));
  };
  std::string path = Format("%.5f %.5f m\n", at(0).x(), at(0).y());
  for (int i = 0; i < kArcs; ++i) {
    const Eigen::Vector2d a = at(i) + along(i), b = at(i + 1) - along(i + 1), c = at(i + 1);
    path += Format("%.5f %.5f %.5f %.5f %.5f %.5f c\n", a.x(), a.y(), b.x(), b.y(), c.x(), c.y());
  }
  return path + "h ";
}

/// A character that Helvetica's standard encoding lacks becomes a question mark.
std::string Escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0) == 0x80) continue;  // the rest of a letter of several bytes
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += byte < 32 || byte > 126 ? '?' : c;
  }
  return out;
}

struct PdfShape {
  std::string operator()(const DiscShape& s) const {
    return Format("%.4f g ", s.grey) + CirclePath(s.centre_mm, 0.5 * s.diameter_mm) + "f\n";
  }
  std::string operator()(const PolygonShape& s) const {
    std::string text = Format("%.4f g ", s.grey);
    const char* verb = "m";
    for (const Eigen::Vector2d& p : s.corners_mm) {
      text += Format("%.5f %.5f %s ", p.x(), p.y(), verb);
      verb = "l";
    }
    return text + "h f\n";
  }
  std::string operator()(const LineShape& s) const {
    return Format("0 G %.3f w %.5f %.5f m %.5f %.5f l S\n", s.line_mm, s.from_mm.x(), s.from_mm.y(),
                  s.to_mm.x(), s.to_mm.y());
  }
  std::string operator()(const TextShape& s) const {
    return Format("0 g BT /F1 %.3f Tf 1 0 0 -1 %.4f %.4f Tm (", s.height_mm, s.at_mm.x(),
                  s.at_mm.y()) +
           Escaped(s.text) + ") Tj ET\n";
  }
};

/// Millimetres from the top left, y down, for what follows.
std::string Content(const Page& page) {
  std::string text = Format("%.9f 0 0 %.9f 0 %.5f cm\n", kPointsPerMm, -kPointsPerMm,
                            page.height_mm * kPointsPerMm);
  text += Format("q %.5f %.5f %.5f %.5f re W n 1 0 0 1 %.5f %.5f cm\n", page.window_mm.x(),
                 page.window_mm.y(), page.window_size_mm.x(), page.window_size_mm.y(),
                 page.shift_mm.x(), page.shift_mm.y());
  for (const Shape& shape : page.clipped) text += std::visit(PdfShape{}, shape);
  text += "Q\n";
  for (const Shape& shape : page.marks) text += std::visit(PdfShape{}, shape);
  return text;
}

}  // namespace

std::string PdfText(const std::vector<Page>& pages) {
  // Objects: 1 catalogue, 2 page tree, 3 font, then a page and its content in turns.
  std::vector<std::string> objects{"<< /Type /Catalog /Pages 2 0 R >>", "",
                                   "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string kids;
  for (const Page& page : pages) {
    const std::string content = Content(page);
    const int number = static_cast<int>(objects.size()) + 1;
    kids += Format("%d 0 R ", number);
    objects.push_back(
        Format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 %.4f %.4f] /Contents %d "
               "0 R /Resources << /Font << /F1 3 0 R >> >> >>",
               page.width_mm * kPointsPerMm, page.height_mm * kPointsPerMm, number + 1));
    objects.push_back(Format("<< /Length %zu >>\nstream\n", content.size()) + content +
                      "endstream");
  }
  // The print dialogue should first offer printing without scaling.
  objects[0] = "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>";
  objects[1] = "<< /Type /Pages /Kids [" + kids + "] " + Format("/Count %zu >>", pages.size());
  std::string text = "%PDF-1.4\n";
  std::string table = Format("xref\n0 %zu\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += Format("%010zu 00000 n \n", text.size());
    text += Format("%zu 0 obj\n", i + 1) + objects[i] + "\nendobj\n";
  }
  const std::size_t start = text.size();
  return text + table +
         Format("trailer\n<< /Size %zu /Root 1 0 R >>\nstartxref\n%zu\n%%%%EOF\n",
                objects.size() + 1, start);
}

}  // namespace dockyard
