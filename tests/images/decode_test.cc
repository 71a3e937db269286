// The grey of image files, beside what OpenCV's imdecode makes of the same bytes.
#include "sim/images/decode.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "sim/images/png.h"
#include "sim/images/png_handle.h"
// Needs <cstdio> before it.
#include <jpeglib.h>

namespace dockyard {
namespace {

constexpr int kWidth = 61, kHeight = 37;

cv::Mat Noise(int type) {
  cv::Mat image(kHeight, kWidth, type);
  cv::RNG random(3);
  random.fill(image, cv::RNG::UNIFORM, 0, image.depth() == CV_16U ? 65536 : 256);
  return image;
}

std::string Encoded(const std::string& ending, int type, const std::vector<int>& options = {}) {
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(cv::imencode(ending, Noise(type), bytes, options));
  return {bytes.begin(), bytes.end()};
}

std::optional<GrayImage> ByOpenCv(const std::string& bytes) {
  const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
  const cv::Mat image = cv::imdecode(file, cv::IMREAD_GRAYSCALE);
  if (image.empty()) return std::nullopt;
  return GrayImage{image.cols, image.rows, {image.begin<uchar>(), image.end<uchar>()}};
}

void ExpectSame(const std::string& bytes, const std::string& what) {
  const auto ours = DecodeGray(bytes), theirs = ByOpenCv(bytes);
  ASSERT_TRUE(ours) << what;
  ASSERT_TRUE(theirs) << what;
  EXPECT_TRUE(*ours == *theirs) << what;
}

struct PngKind {
  int bits, colour, interlace;
  bool gamma, transparent;
};

/// A PNG of random numbers, of any kind that the format has.
std::string PngOf(const PngKind& kind) {
  PngWriter writer;
  std::vector<png_byte> noise(8 * kWidth * kHeight);
  cv::Mat view(1, static_cast<int>(noise.size()), CV_8UC1, noise.data());
  cv::RNG random(4);
  random.fill(view, cv::RNG::UNIFORM, 0, 256);
  std::vector<png_bytep> rows;
  for (int y = 0; y < kHeight; ++y) rows.push_back(noise.data() + y * 8 * kWidth);
  std::vector<png_color> palette(1 << std::min(kind.bits, 8));
  for (std::size_t i = 0; i < palette.size(); ++i)
    palette[i] = {noise[i], noise[i + 1], noise[i + 2]};
  const png_color_16 clear{.index = 1, .red = 2, .green = 3, .blue = 4, .gray = 1};
  const bool written = writer.Run([&] {
    png_set_IHDR(writer.png, writer.info, kWidth, kHeight, kind.bits, kind.colour, kind.interlace,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.colour == PNG_COLOR_TYPE_PALETTE) {
      png_set_PLTE(writer.png, writer.info, palette.data(), static_cast<int>(palette.size()));
    }
    if (kind.gamma) png_set_gAMA(writer.png, writer.info, 1.0);
    if (kind.transparent) png_set_tRNS(writer.png, writer.info, noise.data(), 2, &clear);
    png_write_info(writer.png, writer.info);
    png_write_image(writer.png, rows.data());
    png_write_end(writer.png, writer.info);
  });
  EXPECT_TRUE(written);
  return writer.bytes;
}

TEST(DecodeGray, HasOpenCvsBitsOfEveryKindOfPng) {
  const std::vector<std::pair<int, std::vector<int>>> kinds{{PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}},
                                                            {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}},
                                                            {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}},
                                                            {PNG_COLOR_TYPE_RGB, {8, 16}},
                                                            {PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}}};
  for (const auto& [colour, depths] : kinds) {
    for (const int bits : depths) {
      for (int variant = 0; variant < 8; ++variant) {
        const bool may_be_clear = (colour & PNG_COLOR_MASK_ALPHA) == 0;
        ExpectSame(PngOf({.bits = bits,
                          .colour = colour,
                          .interlace = variant & 1 ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                          .gamma = (variant & 2) != 0,
                          .transparent = (variant & 4) != 0 && may_be_clear}),
                   "colour type " + std::to_string(colour) + ", " + std::to_string(bits) +
                       " bits, variant " + std::to_string(variant));
      }
    }
  }
}

TEST(DecodeGray, HasOpenCvsBitsOfJpegs) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    for (const int quality : {10, 75, 100}) {
      for (const int progressive : {0, 1}) {
        ExpectSame(
            Encoded(".jpg", type,
                    {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_PROGRESSIVE, progressive}),
            std::to_string(quality) + " " + std::to_string(progressive));
      }
    }
  }
}

TEST(DecodeGray, HasOpenCvsBitsOfPgmAndPpm) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_16UC1, CV_16UC3}) {
    for (const int binary : {0, 1}) {
      const std::string ending = CV_MAT_CN(type) == 1 ? ".pgm" : ".ppm";
      ExpectSame(Encoded(ending, type, {cv::IMWRITE_PXM_BINARY, binary}), ending);
    }
  }
  for (const char* text : {"P2 # of few levels\n3 2\n7\n0 1 2\n3 7 9\n",
                           "P3 2 1 100 0 50 100 7 7 7\n", "P2 2 1 4095\n4095 256\n",
                           "P5 3 2 7\nabcdef", "P5 1 2 300\n\1\2\3\4", "P6\n#a\n1 1 9\n\1\2\3"}) {
    ExpectSame(text, text);
  }
}

TEST(DecodeGray, IsWithinALevelOfOpenCvsOfWebps) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
    for (const int quality : {40, 101}) {  // 101: lossless
      const std::string bytes = Encoded(".webp", type, {cv::IMWRITE_WEBP_QUALITY, quality});
      const auto ours = DecodeGray(bytes), theirs = ByOpenCv(bytes);
      ASSERT_TRUE(ours && theirs);
      ASSERT_EQ(ours->pixels.size(), theirs->pixels.size());
      for (std::size_t i = 0; i < ours->pixels.size(); ++i) {
        ASSERT_NEAR(ours->pixels[i], theirs->pixels[i], 1);
      }
    }
  }
}

/// EXIF with nothing but an orientation.
std::string Exif(char orientation, bool big_endian) {
  if (big_endian) {
    return std::string("MM\0*\0\0\0\x8\0\1\1\x12\0\3\0\0\0\1\0", 19) + orientation +
           std::string(6, '\0');
  }
  return std::string("II*\0\x8\0\0\0\1\0\x12\1\3\0\1\0\0\0", 18) + orientation +
         std::string(7, '\0');
}

std::string Png(const std::string& exif) {
  PngWriter writer;
  std::vector<png_byte> pixels(kWidth * kHeight), block(exif.begin(), exif.end());
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<png_byte>(i % 251);
  std::vector<png_bytep> rows;
  for (int y = 0; y < kHeight; ++y) rows.push_back(pixels.data() + y * kWidth);
  const bool written = writer.Run([&] {
    png_set_IHDR(writer.png, writer.info, kWidth, kHeight, 8, PNG_COLOR_TYPE_GRAY, 0, 0, 0);
    png_set_eXIf_1(writer.png, writer.info, static_cast<png_uint_32>(block.size()), block.data());
    png_write_info(writer.png, writer.info);
    png_write_image(writer.png, rows.data());
    png_write_end(writer.png, writer.info);
  });
  EXPECT_TRUE(written);
  return writer.bytes;
}

TEST(DecodeColour, HasOpenCvsBitsOfPngsJpegsAndPpms) {
  for (const auto& [ending, type] : {std::pair(".png", CV_8UC3),
                                     {".png", CV_16UC3},
                                     {".png", CV_8UC1},
                                     {".jpg", CV_8UC3},
                                     {".jpg", CV_8UC1},
                                     {".ppm", CV_8UC3},
                                     {".pgm", CV_8UC1}}) {
    const std::string bytes = Encoded(ending, type);
    const cv::Mat file(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
    const cv::Mat bgr = cv::imdecode(file, cv::IMREAD_COLOR);
    const std::optional<RgbImage> ours = DecodeColour(bytes);
    ASSERT_TRUE(ours && ours->width == bgr.cols && ours->height == bgr.rows) << ending;
    int worst = 0;
    for (int y = 0; y < bgr.rows; ++y) {
      for (int x = 0; x < bgr.cols; ++x) {
        for (int k = 0; k < 3; ++k) {
          const int mine = ours->pixels[static_cast<std::size_t>(3 * (y * bgr.cols + x) + k)];
          worst = std::max(worst, std::abs(mine - bgr.at<cv::Vec3b>(y, x)[2 - k]));
        }
      }
    }
    EXPECT_EQ(worst, 0) << ending << " of type " << type;
  }
}

TEST(DecodeGray, TurnsAnImageUprightAsItsExifSays) {
  const std::string jpeg = Encoded(".jpg", CV_8UC1);
  const GrayImage as_stored = *DecodeGray(jpeg);
  for (char orientation = 0; orientation <= 9; ++orientation) {
    for (const bool big_endian : {false, true}) {
      const std::string exif = Exif(orientation, big_endian);
      const std::string name = "orientation " + std::to_string(orientation);
      ExpectSame(Png(exif), name);
      std::string segment = std::string("\xff\xe1\0", 3) + static_cast<char>(8 + exif.size()) +
                            std::string("Exif\0\0", 6) + exif;
      const std::string held = jpeg.substr(0, 2) + segment + jpeg.substr(2);
      ExpectSame(held, name);
      EXPECT_EQ(*DecodeGray(held) == as_stored, orientation < 2 || orientation > 8) << name;
    }
  }
}

/// A colour JPEG: of four inks, or with a scan for each frequency of each colour.
std::string OddJpeg(bool four_inks, bool many_scans) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* out = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &out, &size);
  jpeg.image_width = jpeg.image_height = 16;
  jpeg.input_components = four_inks ? 4 : 3;
  jpeg.in_color_space = four_inks ? JCS_CMYK : JCS_RGB;
  jpeg_set_defaults(&jpeg);
  std::vector<jpeg_scan_info> scans{{3, {0, 1, 2, 0}, 0, 0, 0, 0}};
  for (int component = 0; component < 3; ++component) {
    for (int k = 1; k < 64; ++k) scans.push_back({1, {component, 0, 0, 0}, k, k, 0, 0});
  }
  if (many_scans) {
    jpeg.scan_info = scans.data();
    jpeg.num_scans = static_cast<int>(scans.size());
  }
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> row(64, 90);
  JSAMPROW rows[] = {row.data()};
  while (jpeg.next_scanline < jpeg.image_height) jpeg_write_scanlines(&jpeg, rows, 1);
  jpeg_finish_compress(&jpeg);
  std::string bytes(reinterpret_cast<char*>(out), size);
  jpeg_destroy_compress(&jpeg);
  free(out);
  return bytes;
}

TEST(DecodeGray, RefusesJpegsOfFourInksAndOfTooManyScans) {
  EXPECT_TRUE(DecodeGray(OddJpeg(false, false)));
  EXPECT_FALSE(DecodeGray(OddJpeg(true, false)));
  EXPECT_FALSE(DecodeGray(OddJpeg(false, true)));
}

TEST(DecodeGray, RefusesOtherBytesCutFilesAndTooManyPixels) {
  for (const char* bytes : {"", "P5", "P5 2 2 255\nabc", "P2 2 1 255\n1", "P2 2 1 0\n1 1",
                            "P5 1 1 65536\nab", "P2 2 1 255\n1 -1", "P4 8 1\na", "BM", "\xff\xd8",
                            "P5 40000 40000 255\n", "P6 6000 6000 255\n"}) {
    EXPECT_FALSE(DecodeGray(bytes)) << bytes;
  }
  for (const char* ending : {".png", ".webp"}) {
    const std::string whole = Encoded(ending, CV_8UC3);
    for (std::size_t length = 0; length < whole.size(); length += 97) {
      EXPECT_FALSE(DecodeGray(whole.substr(0, length))) << ending << length;
    }
  }
}

}  // namespace
}  // namespace dockyard
