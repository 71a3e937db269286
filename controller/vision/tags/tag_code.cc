#include "controller/vision/tags/tag_code.h"

#include "controller/base/check.h"
#include "controller/vision/tags/april_families.h"
#include "controller/vision/tags/aruco_families.h"

namespace dockyard {
namespace {

TagCells BlackCells(const TagFamily& family) {
  const auto count = static_cast<std::size_t>(family.across * family.across);
  return {.across = family.across,
          .at_border = family.at_border,
          .margin = family.margin,
          .black = std::vector<std::uint8_t>(count, 1)};
}

void Whiten(TagCells& cells, int column, int row) {
  cells.black[static_cast<std::size_t>(row * cells.across + column)] = 0;
}

/// Ring number `inwards` of squares, 0 the outermost.
void WhitenRing(TagCells& cells, int inwards) {
  const int last = cells.across - 1 - inwards;
  for (int i = inwards; i <= last; ++i) {
    Whiten(cells, i, inwards);
    Whiten(cells, i, last);
    Whiten(cells, inwards, i);
    Whiten(cells, last, i);
  }
}

/// White is a 1 of the code, whose highest bit is the first. The ring on the white side of the
/// border is white, that on the other black.
TagCells CellsOf(const apriltag_family_t& april, const TagFamily& family, int id) {
  TagCells cells = BlackCells(family);
  const int border = (family.across - family.at_border) / 2;
  WhitenRing(cells, april.reversed_border ? border : border - 1);
  const std::uint64_t code = april.codes[id];
  for (std::uint32_t i = 0; i < april.nbits; ++i) {
    if ((code >> (april.nbits - 1 - i) & 1u) == 0) continue;
    Whiten(cells, border + static_cast<int>(april.bit_x[i]),
           border + static_cast<int>(april.bit_y[i]));
  }
  return cells;
}

/// A ring of white, one of black, then the bits, white for 1.
TagCells CellsOf(const cv::aruco::Dictionary& dictionary, const TagFamily& family, int id) {
  TagCells cells = BlackCells(family);
  WhitenRing(cells, 0);
  const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(
      dictionary.bytesList.rowRange(id, id + 1), dictionary.markerSize);
  for (int row = 0; row < bits.rows; ++row) {
    for (int column = 0; column < bits.cols; ++column) {
      if (bits.at<std::uint8_t>(row, column) != 0) Whiten(cells, column + 2, row + 2);
    }
  }
  return cells;
}

}  // namespace

std::vector<std::string> TagFamilyNames() {
  std::vector<std::string> names = AprilFamilyNames();
  for (const std::string& name : ArucoFamilyNames()) names.push_back(name);
  return names;
}

std::optional<TagFamily> TagFamilyNamed(const std::string& name) {
  if (const AprilFamily april = AprilFamilyNamed(name)) {
    return TagFamily{.name = name,
                     .aruco = false,
                     .ids = static_cast<int>(april->ncodes),
                     .across = april->total_width,
                     .at_border = april->width_at_border,
                     .margin = april->reversed_border ? 0 : 1};
  }
  if (const cv::Ptr<cv::aruco::Dictionary> aruco = ArucoFamilyNamed(name)) {
    return TagFamily{.name = name,
                     .aruco = true,
                     .ids = aruco->bytesList.rows,
                     .across = aruco->markerSize + 4,
                     .at_border = aruco->markerSize + 2,
                     .margin = 1};
  }
  return std::nullopt;
}

std::vector<TagCells> CellsOf(const TagFamily& family, const std::vector<int>& ids) {
  const AprilFamily april = AprilFamilyNamed(family.name);
  const cv::Ptr<cv::aruco::Dictionary> aruco = ArucoFamilyNamed(family.name);
  DOCKYARD_CHECK(april != nullptr || !aruco.empty());
  std::vector<TagCells> cells;
  for (const int id : ids) {
    DOCKYARD_CHECK(id >= 0 && id < family.ids);
    cells.push_back(april ? CellsOf(*april, family, id) : CellsOf(*aruco, family, id));
  }
  return cells;
}

void SetTagCells(FiducialBoard& board) {
  for (SquareTag& tag : board.tags) {
    const std::optional<TagFamily> family = TagFamilyNamed(tag.family);
    DOCKYARD_CHECK(family.has_value());
    tag.cells = CellsOf(*family, {tag.id})[0];
  }
}

}  // namespace dockyard
