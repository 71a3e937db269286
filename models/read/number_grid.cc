#include "models/read/number_grid.h"

#include "controller/base/number_text.h"
#include "models/read/config_error.h"

namespace dockyard {
namespace {

void AddNumber(const YamlNode& node, NumberGrid& grid) {
  double value = 0.0;
  if (node.kind != YamlNode::Kind::kScalar || node.quoted || !ParseNumber(node.scalar, value)) {
    throw ConfigError(node.place.Text() + ": " + grid.path + ": expected a finite number, found " +
                      node.Found());
  }
  grid.values.push_back(value);
  grid.places.push_back(node.place);
}

void AddRows(const YamlNode& list, NumberGrid& grid) {
  for (const YamlNode& row : list.items) {
    if (row.kind != YamlNode::Kind::kSequence ||
        row.items.size() != list.items.front().items.size()) {
      throw ConfigError(row.place.Text() + ": " + grid.path +
                        ": expected rows of equal length, found another");
    }
    for (const YamlNode& number : row.items) AddNumber(number, grid);
  }
  grid.rows = static_cast<int>(list.items.size());
  grid.cols = static_cast<int>(list.items.front().items.size());
}

int WholeNumber(const YamlNode& node, const std::string& path) {
  double value = 0.0;
  const bool whole = node.kind == YamlNode::Kind::kScalar && ParseNumber(node.scalar, value) &&
                     value >= 0.0 && value <= 1e6 && value == static_cast<int>(value);
  if (!whole) {
    throw ConfigError(node.place.Text() + ": " + path + ": expected a whole number, found " +
                      node.Found());
  }
  return static_cast<int>(value);
}

}  // namespace

std::string NumberGrid::Place() const { return place.Text() + ": " + path; }

void NumberGrid::Refuse(std::size_t index, const std::string& expected) const {
  throw ConfigError(places[index].Text() + ": " + path + ": expected " + expected + ", found '" +
                    NumberText(values[index]) + "'");
}

void NumberGrid::RequireShape(int wanted_rows, int wanted_cols) const {
  const bool flat = rows == 1 && cols == wanted_rows * wanted_cols;
  if ((rows == wanted_rows && cols == wanted_cols) || flat) return;
  throw ConfigError(Place() + ": expected a matrix of " + std::to_string(wanted_rows) + " x " +
                    std::to_string(wanted_cols) + ", found one of " + std::to_string(rows) + " x " +
                    std::to_string(cols));
}

void NumberGrid::RequireCount(std::size_t wanted) const {
  if (count() == wanted) return;
  throw ConfigError(Place() + ": expected " + std::to_string(wanted) + " numbers, found " +
                    std::to_string(count()));
}

NumberGrid ReadGrid(const YamlNode& node, const std::string& path) {
  NumberGrid grid{.place = node.place, .path = path};
  const YamlNode* data = &node;
  if (node.kind == YamlNode::Kind::kMapping) {
    data = node.Find("data");
    if (!data) throw ConfigError(grid.Place() + ": missing key 'data'");
  }
  if (data->kind == YamlNode::Kind::kScalar) {
    AddNumber(*data, grid);
  } else if (data->kind == YamlNode::Kind::kSequence) {
    const bool nested =
        !data->items.empty() && data->items.front().kind == YamlNode::Kind::kSequence;
    if (nested) {
      AddRows(*data, grid);
    } else {
      for (const YamlNode& number : data->items) AddNumber(number, grid);
    }
  } else if (data->kind == YamlNode::Kind::kMapping) {
    throw ConfigError(grid.Place() + ": expected a list of numbers, found a mapping");
  }
  if (grid.rows == 0) grid.rows = 1, grid.cols = static_cast<int>(grid.count());
  const YamlNode *rows = node.Find("rows"), *cols = node.Find("cols");
  if (!rows || !cols) return grid;
  grid.rows = WholeNumber(*rows, path + ".rows");
  grid.cols = WholeNumber(*cols, path + ".cols");
  const auto wanted = static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.cols);
  if (wanted != grid.count()) {
    throw ConfigError(data->place.Text() + ": " + path + ".data: expected " +
                      std::to_string(grid.rows) + " x " + std::to_string(grid.cols) +
                      " numbers, found " + std::to_string(grid.count()));
  }
  return grid;
}

}  // namespace dockyard
