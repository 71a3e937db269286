#include "sim/plant/height_file.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "sim/images/deep_png.h"
#include "sim/images/tiff.h"

namespace dockyard {
namespace {

// Four times the yard's cells at most. An ASCII grid takes up to 8 bytes a sample.
constexpr std::int64_t kMostSamples = 16'000'000;
constexpr std::size_t kMostBytes = std::size_t{8} * kMostSamples;

[[noreturn]] void Refuse(const std::string& file, int line, const std::string& expected,
                         const std::string& found = "") {
  throw ConfigError(file + (line > 0 ? ":" + std::to_string(line) : "") + ": expected " + expected +
                    (found.empty() ? "" : ", found " + found));
}

void CheckSize(const std::string& file, double columns, double rows) {
  if (columns >= 2.0 && rows >= 2.0 && columns * rows <= static_cast<double>(kMostSamples)) return;
  Refuse(file, 0, "2 to 16 million heights in at least 2 rows and columns",
         NumberText(columns) + " x " + NumberText(rows));
}

// An ASCII grid's words, with their lines.
class Words {
 public:
  Words(const std::string& file, std::string_view text) : file_(file), rest_(text) {}

  std::string_view Next() {
    const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    std::size_t at = 0;
    for (; at < rest_.size() && is_space(rest_[at]); ++at) line_ += rest_[at] == '\n' ? 1 : 0;
    std::size_t end = at;
    while (end < rest_.size() && !is_space(rest_[end])) ++end;
    const std::string_view word = rest_.substr(at, end - at);
    rest_.remove_prefix(end);
    return word;
  }
  double Number(const std::string& what) {
    const std::string_view word = Next();
    double value = 0.0;
    if (ParseNumber(word, value)) return value;
    Refuse(file_, line_, what,
           word.empty() ? "the end" : "'" + std::string(word.substr(0, 40)) + "'");
  }
  /// The next word is no number.
  bool AtKey() const {
    Words ahead = *this;
    const std::string_view word = ahead.Next();
    return !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0;
  }
  int line() const { return line_; }

 private:
  const std::string& file_;
  std::string_view rest_;
  int line_ = 1;
};

// https://desktop.arcgis.com/en/arcmap/latest/manage-data/raster-and-images/esri-ascii-raster-format.htm
// Where its corner lies does not count.
HeightMap FromAscii(const std::string& file) {
  const std::string text = ReadText(file, kMostBytes);
  Words words(file, text);
  std::map<std::string, double> header;
  while (words.AtKey()) {
    std::string key;
    for (const char c : words.Next()) key += static_cast<char>(std::tolower(c));
    header[key] = words.Number("a number for '" + key.substr(0, 40) + "'");
    if (header.size() > 6) Refuse(file, words.line(), "at most six keys");
  }
  for (const char* key : {"ncols", "nrows", "cellsize"}) {
    if (!header.contains(key)) Refuse(file, 1, std::string("the key '") + key + "' in the header");
  }
  CheckSize(file, header["ncols"], header["nrows"]);
  const double cell_m = header["cellsize"];
  if (!(cell_m > 0.0)) Refuse(file, 0, "a cellsize above 0", NumberText(cell_m));
  HeightMap map{
      static_cast<int>(header["ncols"]), static_cast<int>(header["nrows"]), cell_m, {}, {}};
  const auto count = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  if (text.size() < count) Refuse(file, 0, std::to_string(count) + " heights", "fewer");
  const double none = header.contains("nodata_value") ? header["nodata_value"] : -9999.0;
  map.heights_m.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = words.Number("a height");
    map.heights_m.push_back(value == none ? std::numeric_limits<float>::quiet_NaN()
                                          : static_cast<float>(value));
  }
  if (!words.Next().empty())
    Refuse(file, words.line(), "no more than " + std::to_string(count) + " heights");
  return map;
}

HeightMap FromImage(const std::string& file, bool png) {
  const std::string bytes = ReadBytes(file, kMostBytes);
  HeightMap map;
  if (png) {
    const auto image = DeepFromPng(bytes);
    if (!image) Refuse(file, 0, "a grey PNG of 8 or 16 bits");
    map = {image->width, image->height, 0.0, {image->pixels.begin(), image->pixels.end()}, {}};
  } else {
    auto image = DecodeTiff(bytes);
    if (!image)
      Refuse(file, 0, "a TIFF of one number a pixel: 8 or 16 bits, or a float of 32 bits");
    map = {image->width, image->height, 0.0, std::move(image->pixels), {}};
  }
  CheckSize(file, map.columns, map.rows);
  return map;
}

}  // namespace

HeightMap LoadHeights(const YardHeights& heights) {
  const std::string& file = heights.file;
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  HeightMap map;
  if (ending == ".asc") {
    map = FromAscii(file);
  } else if (ending == ".png" || ending == ".tif" || ending == ".tiff") {
    map = FromImage(file, ending == ".png");
  } else {
    Refuse(file, 0, "a file of heights that ends in .png, .tif, .tiff or .asc");
  }
  if (!std::isnan(heights.cell_m)) map.cell_m = heights.cell_m;
  if (map.cell_m == 0.0) Refuse(file, 0, "yard.heights.cell_m with it, as it states no distance");
  for (float& height_m : map.heights_m) height_m *= static_cast<float>(heights.scale_m);
  map.X_GM = heights.X_GM;
  return map;
}

}  // namespace dockyard
