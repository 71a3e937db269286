// The bytes that docs/reference/report_payload.md promises.
#include "sim/page/payload.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <limits>

#include "sim/base/bytes.h"
#include "sim/page/page_template.h"

namespace dockyard {
namespace {

std::string FromBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned value = 0, bits = 0;
  for (const char digit : text) {
    if (digit == '=') break;
    value = value << 6 | static_cast<unsigned>(digits.find(digit));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(value >> bits);
  }
  return bytes;
}

std::string Gunzip(const std::string& bytes) {
  std::string out(1 << 20, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return out;
}

/// The blob that was added last.
std::string Blob(const Payload& payload, const Json& place) {
  const std::string bytes = Gunzip(FromBase64(payload.Text(Json::object())));
  const std::size_t begin = 16;  // magic, length, "{}", two zeros
  return bytes.substr(begin + place["offset"].get<std::size_t>(),
                      place["length"].get<std::size_t>());
}

std::string Bytes(std::initializer_list<int> numbers) {
  std::string bytes;
  for (const int number : numbers) bytes += static_cast<char>(number);
  return bytes;
}

TEST(Base64, FollowsTheVectorsOfRfc4648) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Base64("\xff\xfe"), "//4=");
}

TEST(Payload, HasMagicLengthHeaderAndBlobs) {
  Payload payload;
  payload.Add("abcde");
  const Json second = payload.Add("xy");
  EXPECT_EQ(second["offset"], 8);
  EXPECT_EQ(second["length"], 2);
  const std::string bytes = Gunzip(FromBase64(payload.Text({{"a", 1}})));
  EXPECT_EQ(bytes, "DOCKREP1" + Bytes({7, 0, 0, 0}) + "{\"a\":1}" + Bytes({0}) + "abcde" +
                       Bytes({0, 0, 0}) + "xy" + Bytes({0, 0}));
}

// The page's own examples.
TEST(Payload, PacksChannelsAsThePageSays) {
  const auto packed = [](const std::vector<double>& values, double quantum) {
    Payload payload;
    const Json channel = payload.AddChannel(values, quantum);
    EXPECT_EQ(channel["quantum"], quantum);
    return Blob(payload, channel);
  };
  EXPECT_EQ(packed({10, 12, 9}, 1.0), Bytes({1, 20, 4, 5}));
  EXPECT_EQ(packed({1000, 1300, 700}, 1.0), Bytes({2, 208, 88, 175, 7, 2, 4}));
  EXPECT_EQ(packed({0.1000, 0.1300, 0.0700}, 1e-4), Bytes({2, 208, 88, 175, 7, 2, 4}));
  EXPECT_EQ(packed({}, 1.0), "");
  // A missing value is -2^31: its zigzag is 2^32 - 1, and back from it comes the difference again.
  EXPECT_EQ(packed({std::numeric_limits<double>::quiet_NaN()}, 1.0),
            Bytes({4, 255, 255, 255, 255}));
  EXPECT_EQ(packed({3e9}, 1.0), packed({std::nan("")}, 1.0));
}

TEST(Page, HasOneMarkForItsDataAndKeepsAllElse) {
  const std::string page(kPageTemplate), mark = "@PAYLOAD@";
  const std::size_t at = page.find(mark);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(page.find(mark, at + 1), std::string::npos);
  EXPECT_EQ(PageWith("data"), page.substr(0, at) + "data" + page.substr(at + mark.size()));
  EXPECT_THAT(page, testing::StartsWith("<!doctype html>"));
  EXPECT_THAT(page, testing::HasSubstr("default-src 'none'"));
}

}  // namespace
}  // namespace dockyard
