#include "models/read/load_tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "controller/vision/tags/tag_code.h"
#include "models/read/config_error.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostTags = 200;  // of one board; assumed, a checkerboard of tags has 50-100
constexpr double kRounding_m = 1e-9;

using Square = std::array<Eigen::Vector2d, 4>;

/// The square of the tag's printed cells but the outer `rings`.
Square SquareOf(const SquareTag& tag, int rings) {
  const double half = 0.5 * (tag.cells.across - 2 * rings) * tag.cell_m();
  return {OnBoard(tag, {-half, -half}), OnBoard(tag, {half, -half}), OnBoard(tag, {half, half}),
          OnBoard(tag, {-half, half})};
}

bool LiesOn(const FiducialBoard& board, const Square& square) {
  return std::all_of(square.begin(), square.end(), [&](const Eigen::Vector2d& p) {
    return std::abs(p.x()) <= 0.5 * board.width_m + kRounding_m &&
           std::abs(p.y()) <= 0.5 * board.height_m + kRounding_m;
  });
}

/// Whether a side of `a` has all of `b` beyond it.
bool HasASideBetween(const Square& a, const Square& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d along = (a[(i + 1) % 4] - a[i]).normalized();
    const Eigen::Vector2d out(along.y(), -along.x());  // the corners go round clockwise, y is down
    if (std::all_of(b.begin(), b.end(),
                    [&](const Eigen::Vector2d& p) { return out.dot(p - a[i]) >= -kRounding_m; })) {
      return true;
    }
  }
  return false;
}

bool Overlap(const Square& a, const Square& b) {
  return !HasASideBetween(a, b) && !HasASideBetween(b, a);
}

std::string Millimetres(double metres) {
  return NumberText(std::round(1e5 * metres) / 100.0) + " mm";
}

}  // namespace

void VisitTags(Keys& keys, std::vector<SquareTag>& tags) {
  const std::vector<std::string> families = TagFamilyNames();
  std::string name = tags.empty() ? families.front() : tags.front().family;
  keys.Word("family", name, families);
  const std::optional<TagFamily> family = TagFamilyNamed(name);
  constexpr int kMostIds = 50000;  // the largest family has 48714
  const int last = keys.reads() ? family->ids - 1 : kMostIds;
  keys.Items("marks", tags, 1, kMostTags, [&](Keys& in, SquareTag& tag) {
    tag.family = name;
    in.Integer("id", tag.id, 0, last);
    in.Number("x_m", tag.p_BT.x(), Between(-3.0, 3.0));
    in.Number("y_m", tag.p_BT.y(), Between(-3.0, 3.0));
    in.Number("size_m", tag.size_m, Positive(2.0));
    in.Degrees(Optional("rotation_deg"), tag.rotation, Between(-180.0, 180.0));
  });
}

void CheckTags(const YamlReader& in, const FiducialBoard& board) {
  const YamlNode* marks = in.Child("tags").Find("marks");
  const auto refuse = [&](std::size_t i, const std::string& expected) {
    throw ConfigError(marks->items[i].place.Text() + ": " +
                      YamlReader::PathOf(in.PathOf("tags") + ".marks", i) + ": expected " +
                      expected);
  };
  for (std::size_t i = 0; i < board.tags.size(); ++i) {
    const SquareTag& tag = board.tags[i];
    const int margin = tag.cells.margin;
    if (!LiesOn(board, SquareOf(tag, margin))) refuse(i, "a tag inside the board, it sticks out");
    if (!LiesOn(board, SquareOf(tag, 0))) {
      refuse(i, "a white margin of " + Millimetres(tag.cell_m()) +
                    ", one square, about the tag; the board ends before");
    }
    for (std::size_t k = 0; k < i; ++k) {
      const SquareTag& other = board.tags[k];
      const std::string number = " number " + std::to_string(k);
      if (other.id == tag.id) refuse(i, "an id that no other tag has, it is that of" + number);
      const int its = other.cells.margin;
      if (Overlap(SquareOf(tag, margin), SquareOf(other, its))) {
        refuse(i, "a tag clear of the others, it overlaps" + number);
      }
      // White margins may lie on one another.
      if (Overlap(SquareOf(tag, 0), SquareOf(other, its)) ||
          Overlap(SquareOf(tag, margin), SquareOf(other, 0))) {
        refuse(i, "a white margin of " + Millimetres(std::max(tag.cell_m(), other.cell_m())) +
                      ", one square, between tags, it is nearer to" + number);
      }
    }
  }
}

}  // namespace dockyard
