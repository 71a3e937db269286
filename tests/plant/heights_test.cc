// Files of heights against planes, which bilinear sampling keeps, and against other programs'
// files.
#include <gmock/gmock.h>
#include <tiffio.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "sim/images/png.h"
#include "sim/plant/height_file.h"
#include "sim/plant/yard.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

constexpr double kFlat_m = 0.5;

/// An ASCII grid of numbers by row and column, 0.5 m apart, with more in its header.
template <typename Law>
std::string Ascii(int columns, int rows, const Law& law, const std::string& more = "") {
  std::ostringstream out;
  out << "ncols " << columns << "\nnrows " << rows
      << "\nxllcorner 434000.5\nyllcorner -12\ncellsize 0.5\n"
      << more;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) out << law(row, column) << " ";
    out << "\n";
  }
  return out.str();
}

class Heights : public testing::Test {
 protected:
  YardModel Yard(const std::string& name, const std::string& bytes, double cell_m = NAN) const {
    YardModel yard{.length_m = 6.0, .width_m = 6.0, .cell_m = 0.1, .undulation_rms_m = 0.0};
    yard.heights.file = folder_.Write(name, bytes);
    yard.heights.cell_m = cell_m;
    return yard;
  }
  std::string Refusal(const YardModel& yard) const {
    return MessageOf([&] { YardGround(yard, kFlat_m, Seed{}); }, folder_);
  }

  ScratchFolder folder_;
};

// Rows go from the top, y upwards; the map's middle lies at its place.
TEST_F(Heights, PlaneLiesWhereItsPlaceAndTurnPutIt) {
  const auto plane = [](int row, int column) { return 10.0 + 0.05 * column - 0.02 * row; };
  YardModel yard = Yard("plane.asc", Ascii(41, 31, plane));
  yard.heights.X_GM = {1.5, -0.5, 0.6};
  yard.heights.scale_m = 2.0;
  const HeightGrid ground = YardGround(yard, kFlat_m, Seed{});
  // Per metre along the map's x and y: 0.1 and 0.04 of the file's, twice that in metres.
  const Eigen::Vector2d slope = Eigen::Rotation2Dd(0.6) * Eigen::Vector2d(0.2, 0.08);
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(2.0, 1.0), {3.5, -2.5}, {-1.2, 0.3}}) {
    EXPECT_NEAR(ground.Height(p.x(), p.y()), slope.dot(p), 1e-6) << p.transpose();
  }
  EXPECT_EQ(ground.Height(0.0, 0.0), 0.0);
  EXPECT_EQ(ground.Height(0.3, -0.3), 0.0);  // level under the target
}

TEST_F(Heights, AddToTheUndulationAndGoOnLevelBeyondTheirBorder) {
  YardModel yard = Yard("step.asc", Ascii(3, 3, [](int, int column) { return 0.1 * column; }));
  yard.undulation_rms_m = 0.01;
  const HeightGrid both = YardGround(yard, kFlat_m, Seed{});
  yard.heights.file.clear();
  const HeightGrid undulation = YardGround(yard, kFlat_m, Seed{});
  // The map reaches 0.5 m to either side of the target, where it is 0.1 m high.
  EXPECT_NEAR(both.Height(3.0, 2.0) - undulation.Height(3.0, 2.0), 0.1, 1e-7);
  EXPECT_NEAR(both.Height(-1.4, 2.0) - undulation.Height(-1.4, 2.0), -0.1, 1e-7);
}

// The same numbers in every kind of file, most of them written by other libraries.
TEST_F(Heights, AreTheSameFromEveryKindOfFile) {
  constexpr int kColumns = 37, kRows = 21;
  const auto law = [](int row, int column) { return (row * 31 + column * 17) % 250; };
  cv::Mat bytes(kRows, kColumns, CV_8U), words(kRows, kColumns, CV_16U),
      floats(kRows, kColumns, CV_32F);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      bytes.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(law(row, column));
      words.at<std::uint16_t>(row, column) = static_cast<std::uint16_t>(law(row, column));
      floats.at<float>(row, column) = static_cast<float>(law(row, column));
    }
  }
  const auto encoded = [](const char* ending, const cv::Mat& image) {
    std::vector<unsigned char> file;
    cv::imencode(ending, image, file);
    return std::string(file.begin(), file.end());
  };
  const auto ground = [&](YardModel yard) {
    yard.heights.scale_m = 0.001;
    return YardGround(yard, kFlat_m, Seed{}).heights_m;
  };
  const std::vector<double> wanted = ground(Yard("a.asc", Ascii(kColumns, kRows, law)));
  EXPECT_GT(*std::max_element(wanted.begin(), wanted.end()), 0.05);
  EXPECT_EQ(ground(Yard("a.png", encoded(".png", bytes), 0.5)), wanted);
  EXPECT_EQ(ground(Yard("b.PNG", encoded(".png", words), 0.5)), wanted);
  EXPECT_EQ(ground(Yard("a.tif", encoded(".tiff", words), 0.5)), wanted);
  EXPECT_EQ(ground(Yard("b.tiff", encoded(".tiff", floats), 0.5)), wanted);
}

TEST_F(Heights, OfATiledTiffAreThoseOfItsStrips) {
  const std::string path = (folder_.path() / "tiles.tif").string();
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 40);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 24);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_INT);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
  TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
  const auto law = [](int row, int column) { return 3 * column - 7 * row; };
  for (int y0 = 0; y0 < 24; y0 += 16) {
    for (int x0 = 0; x0 < 40; x0 += 16) {
      std::vector<std::int16_t> tile;
      for (int i = 0; i < 256; ++i) {
        tile.push_back(static_cast<std::int16_t>(law(y0 + i / 16, x0 + i % 16)));
      }
      TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(x0),
                    static_cast<std::uint32_t>(y0), 0, 0);
    }
  }
  TIFFClose(tiff);
  const HeightMap map = LoadHeights({.file = path, .cell_m = 0.5});
  ASSERT_EQ(map.columns, 40);
  ASSERT_EQ(map.rows, 24);
  for (int row = 0; row < 24; ++row) {
    for (int column = 0; column < 40; ++column) {
      EXPECT_EQ(map.heights_m[static_cast<std::size_t>(row * 40 + column)], law(row, column));
    }
  }
}

TEST_F(Heights, MustBeThereAllOverTheYardAndOnlyThere) {
  const auto hole = [](int at_row, int at_column) {
    return [=](int row, int column) { return row == at_row && column == at_column ? -1.0 : 0.5; };
  };
  const std::string none = "NODATA_value -1\n";
  EXPECT_NO_THROW(YardGround(Yard("a.asc", Ascii(41, 41, hole(0, 0), none)), kFlat_m, Seed{}));
  EXPECT_THAT(Refusal(Yard("b.asc", Ascii(41, 41, hole(20, 24), none))),
              HasSubstr("b.asc: expected heights all over the yard, within 20 m of the target's, "
                        "found none at x = "));
  EXPECT_THAT(Refusal(Yard("c.asc", Ascii(41, 41, [](int, int column) { return 3 * column; }))),
              HasSubstr("within 20 m of the target's"));
}

TEST_F(Heights, OfBadFilesAreRefusedWithTheirPlace) {
  const auto flat = [](int, int) { return 1; };
  const std::string good = Ascii(4, 3, flat);
  const GrayImage grey{4, 3, std::vector<std::uint8_t>(12, 7)};
  const struct {
    std::string name, bytes, message;
  } cases[] = {
      {"a.txt", good, "a.txt: expected a file of heights that ends in .png, .tif, .tiff or .asc"},
      {"a.asc", Replaced(good, "cellsize 0.5\n", ""), "a.asc:1: expected the key 'cellsize'"},
      {"b.asc", Replaced(good, "cellsize 0.5", "cellsize -2"),
       "expected a cellsize above 0, found -2"},
      {"c.asc", Replaced(good, "ncols 4", "ncols 400000000"), "expected 2 to 16 million heights"},
      {"d.asc", Replaced(good, "ncols 4", "ncols 5"), "d.asc:9: expected a height, found the end"},
      {"e.asc", good + "5\n", "e.asc:9: expected no more than 12 heights"},
      {"f.asc", Replaced(good, "\n1 1 1 1", "\n1 1 one 1"),
       "f.asc:6: expected a height, found 'one'"},
      {"g.asc", Replaced(good, "nrows 3", "nrows 1e3"),
       "g.asc: expected 4000 heights, found fewer"},
      {"a.png", "no image", "a.png: expected a grey PNG of 8 or 16 bits"},
      {"b.png", EncodePng(AsColour(grey)), "b.png: expected a grey PNG of 8 or 16 bits"},
      {"c.png", EncodePng(grey), "c.png: expected yard.heights.cell_m with it"},
      {"a.tif", "II*", "a.tif: expected a TIFF of one number a pixel"},
  };
  for (const auto& each : cases) {
    EXPECT_THAT(Refusal(Yard(each.name, each.bytes)), HasSubstr(each.message)) << each.name;
  }
}

}  // namespace
}  // namespace dockyard
