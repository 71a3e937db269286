// Against Python's hashlib and hmac.
#include "sim/base/secret.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <future>
#include <set>
#include <stdexcept>
#include <vector>

#include "sim/base/files.h"

namespace dockyard {
namespace {

using testing::HasSubstr;

Secret Counting() {
  Secret secret;
  for (std::size_t i = 0; i < secret.bytes.size(); ++i)
    secret.bytes[i] = static_cast<std::uint8_t>(i);
  return secret;
}

class SecretFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  void Write(const std::string& content) { std::ofstream(file_) << content; }

  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("secret_" + SecretText(NewSecret()));
};

TEST(Secret, FingerprintIsItsSha256) {
  EXPECT_EQ(Fingerprint(Counting()),
            "be45cb2605bf36bebde684841a28f0fd43c69850a3dce5fedba69928ee3a8991");
}

TEST(Secret, SealedBitsAreThoseOfHmacSha256) {
  EXPECT_EQ(SealedBits(Counting(), "world", {1, 2, 3}), 0x394297ae6fdd3297ull);
  EXPECT_EQ(SealedBits(Counting(), "stream/imu", {1}), 0xc9e4be66ac55ada9ull);
}

TEST(Secret, EachIsAnother) {
  std::set<std::string> texts;
  for (int i = 0; i < 100; ++i) texts.insert(SecretText(NewSecret()));
  EXPECT_EQ(texts.size(), 100u);
}

TEST_F(SecretFile, IsMadeOnceAndOnlyForItsOwner) {
  const Secret made = ReadOrMakeSecret(file_);
  EXPECT_EQ(ReadOrMakeSecret(file_), made);
  EXPECT_EQ(ReadSecret(file_), made);
  struct stat about {};
  ASSERT_EQ(::stat(file_.c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
}

TEST_F(SecretFile, IsTheSameForAllWhoMakeItAtOnce) {
  std::vector<std::future<Secret>> made;
  for (int i = 0; i < 8; ++i) {
    made.push_back(std::async(std::launch::async, [&] { return ReadOrMakeSecret(file_); }));
  }
  const Secret kept = made.front().get();
  for (std::size_t i = 1; i < made.size(); ++i) EXPECT_EQ(made[i].get(), kept);
}

TEST_F(SecretFile, IsNeverReplaced) {
  Write("mine");
  EXPECT_THROW(ReadOrMakeSecret(file_), std::invalid_argument);
  EXPECT_EQ(*ReadWhole(file_), "mine");
}

TEST_F(SecretFile, OfOtherContentIsRefused) {
  for (const std::string content :
       {"", "00", "000102030405060708090a0b0c0d0e0g", "000102030405060708090a0b0c0d0e0f0"}) {
    Write(content);
    try {
      ReadSecret(file_);
      FAIL() << content;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("expected 32 hexadecimal digits"));
    }
  }
  Write(" 000102030405060708090A0B0C0D0E0F\r\n");
  EXPECT_EQ(ReadSecret(file_), Counting());
}

}  // namespace
}  // namespace dockyard
