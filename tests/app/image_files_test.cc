#include "sim/app/image_files.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <chrono>
#include <opencv2/imgcodecs.hpp>

#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

std::string Noise(const std::string& ending) {
  cv::Mat image(70, 90, CV_8UC1);
  cv::RNG random(1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(cv::imencode(ending, image, bytes));
  return {bytes.begin(), bytes.end()};
}

std::string MessageFor(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const std::string file = folder.Write(name, bytes);
  return MessageOf([&] { LoadGray(file); }, folder);
}

TEST(ImageFiles, WholeOnesAreReadAndCutOnesRefusedOrNamed) {
  for (const char* ending : {".png", ".pgm", ".webp", ".jpg"}) {
    const std::string whole = Noise(ending), name = std::string("a") + ending;
    EXPECT_EQ(MessageFor(name, whole), "(no error)") << ending;
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const ScratchFolder folder;
      const auto length = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
      const std::string file = folder.Write(name, whole.substr(0, length));
      const std::string message = MessageOf([&] { LoadGray(file); }, folder);
      EXPECT_TRUE(message != "(no error)" || IsCutJpeg(file)) << ending << share;
    }
  }
}

TEST(ImageFiles, TooManyPixelsAreRefusedBeforeDecoding) {
  // 0.9 MB of PNG were 4.2 GB of memory and 12 s.
  std::string png = Noise(".png");
  png.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));
  EXPECT_EQ(MessageFor("a.png", png),
            "a.png: expected an image of 1 to 40 million pixels, found 30000 x 30000");
  EXPECT_THAT(MessageFor("a.pgm", "P5 100000 100000 255\n"), HasSubstr("found 100000 x 100000"));
  EXPECT_THAT(MessageFor("a.pgm", "P5 0 5 255\n"), HasSubstr("found 0 x 5"));
}

TEST(ImageFiles, WhatIsNoImageIsRefused) {
  EXPECT_THAT(MessageFor("a.png", ""), HasSubstr("found something else"));
  EXPECT_THAT(MessageFor("a.png", "no image"), HasSubstr("a.png: expected an image (PNG, JPEG"));
  EXPECT_THAT(MessageFor("a.gif", "GIF89a\1\1\1\1"), HasSubstr("found a GIF"));
  EXPECT_EQ(MessageFor("a.bmp", Noise(".bmp")),
            "a.bmp: expected an image (PNG, JPEG, PGM, PPM or WebP), found a BMP");
  EXPECT_THAT(MessageFor("a.tif", Noise(".tif")), HasSubstr("PPM or WebP), found a TIFF"));
  const ScratchFolder folder;
  const std::string pipe = (folder.path() / "pipe.png").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(MessageOf([&] { LoadGray(pipe); }, folder), "pipe.png: not a regular file");
}

}  // namespace
}  // namespace dockyard
