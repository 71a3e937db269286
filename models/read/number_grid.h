// Matrices and lists of numbers as calibrations write them, with the place of each number.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// Row by row.
struct NumberGrid {
  int rows = 0, cols = 0;
  std::vector<double> values{};
  std::vector<YamlPlace> places{};
  YamlPlace place{};  // of the whole
  std::string path{};

  std::size_t count() const { return values.size(); }
  /// "file:line:col: path", of the whole or of one number.
  std::string Place() const;
  [[noreturn]] void Refuse(std::size_t index, const std::string& expected) const;
  /// Throws ConfigError for another shape. A plain list of rows x cols numbers takes that shape.
  void RequireShape(int rows, int cols) const;
  void RequireCount(std::size_t count) const;

  template <int kRows, int kCols>
  Eigen::Matrix<double, kRows, kCols> matrix() const {
    Eigen::Matrix<double, kRows, kCols> m;
    for (int r = 0; r < kRows; ++r) {
      for (int c = 0; c < kCols; ++c) m(r, c) = values[static_cast<std::size_t>(r * kCols + c)];
    }
    return m;
  }
};

/// {rows, cols, data}, a list of rows, a plain list, or one number. Throws ConfigError.
NumberGrid ReadGrid(const YamlNode& node, const std::string& path);

}  // namespace dockyard
