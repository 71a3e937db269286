#include "sim/images/image_size.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "sim/images/png.h"

namespace dockyard {
namespace {

std::string Encoded(const std::string& ending, int width, int height, int type,
                    const std::vector<int>& options = {}) {
  std::vector<std::uint8_t> bytes;
  EXPECT_TRUE(
      cv::imencode(ending, cv::Mat(height, width, type, cv::Scalar::all(90)), bytes, options));
  return {bytes.begin(), bytes.end()};
}

void ExpectSize(const std::string& bytes, int width, int height, const std::string& what) {
  const auto size = StatedImageSize(bytes);
  ASSERT_TRUE(size) << what;
  EXPECT_EQ(size->width, width) << what;
  EXPECT_EQ(size->height, height) << what;
}

TEST(ImageSize, IsTheSizeThatTheDecoderFinds) {
  for (const int width : {1, 37, 300, 5000}) {
    for (const char* ending : {".png", ".jpg", ".pgm", ".webp"}) {
      ExpectSize(Encoded(ending, width, 70, CV_8UC1), width, 70, ending);
      const std::string colour = ending == std::string(".pgm") ? ".ppm" : ending;
      ExpectSize(Encoded(colour, width, 70, CV_8UC3), width, 70, colour);
    }
  }
  ExpectSize(Encoded(".jpg", 37, 70, CV_8UC3, {cv::IMWRITE_JPEG_PROGRESSIVE, 1}), 37, 70, "jpg");
  ExpectSize(Encoded(".webp", 37, 70, CV_8UC3, {cv::IMWRITE_WEBP_QUALITY, 101}), 37, 70, "VP8L");
  ExpectSize(Encoded(".webp", 37, 70, CV_8UC4), 37, 70, "with alpha");
  ExpectSize("P2 # a comment\n# and 7 9 one more\n37\t70\n255\n", 37, 70, "pgm");
}

TEST(ImageSize, IsNoneOfOtherBytesAndOfCutHeaders) {
  for (const char* bytes : {"", "x", "P", "P5", "P5 37", "P7 37 70", "P4 37 70", "GIF89a", "BM",
                            "II*", "\xff\xd8", "\xff\xd8\xff\xe0", "RIFF____WEBP"}) {
    EXPECT_FALSE(StatedImageSize(bytes)) << bytes;
  }
  for (const char* ending : {".png", ".jpg", ".pgm", ".webp"}) {
    const std::string whole = Encoded(ending, 37, 70, CV_8UC1);
    for (std::size_t length = 0; length < std::min<std::size_t>(whole.size(), 400); ++length) {
      const auto size = StatedImageSize(whole.substr(0, length));
      // What it says is either nothing, no image, or a part of a decimal number.
      if (size && size->usable()) {
        EXPECT_LE(size->width, 37) << ending << length;
        EXPECT_LE(size->height, 70) << ending << length;
      }
    }
  }
}

TEST(ImageSize, IsUsableUpToFortyMegapixels) {
  EXPECT_TRUE((ImageSize{8000, 5000}).usable());
  EXPECT_FALSE((ImageSize{8000, 5001}).usable());
  EXPECT_FALSE((ImageSize{0, 5}).usable());
  EXPECT_FALSE((ImageSize{5, -1}).usable());
  EXPECT_FALSE((ImageSize{4294967295, 4294967295}).usable());
}

}  // namespace
}  // namespace dockyard
