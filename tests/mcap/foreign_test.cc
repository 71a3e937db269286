// Files as other programs write them hold the same messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/bytes.h"
#include "sim/base/random.h"
#include "sim/mcap/mcap_reader.h"
#include "sim/mcap/mcap_repair.h"
#include "sim/mcap/mcap_writer.h"
#include "support/fake_runs.h"
#include "support/foreign_log.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

void WriteOurs(const fs::path& file) {
  McapWriter writer(file, {.profile = "ros2", .library = "test"});
  writer.Attach({0, 0, "header.json", "application/json", "{}"});
  const auto schema = writer.AddSchema("a/msg/B", "ros2msg", "float64 x");
  const auto channel = writer.AddChannel(schema, "/one", "cdr");
  RandomStream draw(5);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const std::string data = std::string(i, 'x') + std::to_string(draw.NextBits());
    writer.Write({channel, i, 20'000'000ull * i, 20'000'000ull * i, data});
  }
  writer.Finish();
}

struct Content {
  std::vector<std::string> messages;
  std::vector<McapAttachment> attachments;
  bool complete = false, guarded = false;
};

Content ContentOf(const fs::path& file) {
  McapReader reader(file);
  Content content;
  while (const auto message = reader.Next()) {
    content.messages.push_back(std::to_string(message->log_time_ns) + " " +
                               std::string(message->data));
  }
  content.attachments = reader.attachments();
  content.complete = reader.complete();
  content.guarded = reader.guarded();
  return content;
}

class ForeignFile : public testing::Test {
 protected:
  ForeignFile() { WriteOurs(ours_); }
  Content Rewritten(const ForeignWriting& how) {
    RewriteForeign(ours_, theirs_, how);
    return ContentOf(theirs_);
  }

  const TemporaryFolder folder_;
  const fs::path ours_ = folder_.path() / "ours.mcap", theirs_ = folder_.path() / "theirs.mcap";
};

TEST_F(ForeignFile, GivesTheSameMessagesInEveryCompressionAndChunkSize) {
  const Content ours = ContentOf(ours_);
  ASSERT_EQ(ours.messages.size(), 200u);
  for (const auto compression : {ForeignCompression::kNone, ForeignCompression::kZstd,
                                 ForeignCompression::kZstdWithoutSize, ForeignCompression::kLz4}) {
    for (const std::size_t chunk_bytes : {1u, 4096u, 1u << 22}) {
      for (const bool all : {true, false}) {
        const Content theirs = Rewritten({.compression = compression,
                                          .check_values = all,
                                          .message_indexes = all,
                                          .summary = all,
                                          .chunk_bytes = chunk_bytes,
                                          .attachments_last = !all,
                                          .private_records = !all});
        EXPECT_EQ(theirs.messages, ours.messages);
        EXPECT_TRUE(theirs.complete);
        EXPECT_EQ(theirs.guarded, all);
        ASSERT_EQ(theirs.attachments.size(), 1u);
        EXPECT_EQ(theirs.attachments[0].data, "{}");
      }
    }
  }
}

TEST_F(ForeignFile, MayHaveNoChunks) {
  EXPECT_EQ(Rewritten({.chunk_bytes = 0}).messages, ContentOf(ours_).messages);
}

TEST_F(ForeignFile, HasTheMemoryOfItsContentNotOfItsClaims) {
  RewriteForeign(ours_, theirs_, {.compression = ForeignCompression::kLz4, .check_values = false});
  std::string bytes = Slurp(theirs_);
  const std::size_t at = bytes.find("lz4") - 4 - 4 - 8;  // the size that the first chunk states
  std::string size;
  PutU64(size, kMostChunkBytes);
  WriteText(theirs_, bytes.replace(at, size.size(), size));
  EXPECT_THROW(ContentOf(theirs_), DataError);
}

TEST_F(ForeignFile, WithCheckValuesIsStillCheckedInEveryByte) {
  RewriteForeign(ours_, theirs_,
                 {.compression = ForeignCompression::kLz4, .chunk_bytes = 1u << 14});
  const std::string bytes = Slurp(theirs_);
  RandomStream draw(9);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = bytes;
    damaged[draw.NextBits() % bytes.size()] ^= static_cast<char>(1 + draw.NextBits() % 255);
    WriteText(theirs_, damaged);
    try {
      EXPECT_FALSE(ContentOf(theirs_).complete);
    } catch (const DataError&) {
    }
  }
}

TEST_F(ForeignFile, ThatWasCutShortIsRepaired) {
  RewriteForeign(ours_, theirs_, {.compression = ForeignCompression::kLz4, .check_values = false});
  const std::string bytes = Slurp(theirs_);
  WriteText(theirs_, bytes.substr(0, bytes.size() / 2));
  const std::size_t left = ContentOf(theirs_).messages.size();
  EXPECT_GT(left, 10u);
  EXPECT_TRUE(RepairMcap(theirs_));
  EXPECT_TRUE(ContentOf(theirs_).complete);
  EXPECT_EQ(ContentOf(theirs_).messages.size(), left);
}

TEST_F(ForeignFile, OfAnUnknownCompressionNamesIt) {
  RewriteForeign(ours_, theirs_, {.compression = ForeignCompression::kLz4, .check_values = false});
  std::string bytes = Slurp(theirs_);
  WriteText(theirs_, bytes.replace(bytes.find("lz4"), 3, "lzo"));
  try {
    ContentOf(theirs_);
    ADD_FAILURE();
  } catch (const DataError& error) {
    EXPECT_STREQ(error.what(), "a chunk is compressed by 'lzo', expected zstd or lz4");
  }
}

}  // namespace
}  // namespace dockyard
