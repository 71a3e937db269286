// What is left of a file that was cut short, and that no changed byte goes unseen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/bytes.h"
#include "sim/base/random.h"
#include "sim/mcap/mcap_reader.h"
#include "sim/mcap/mcap_repair.h"
#include "sim/mcap/mcap_writer.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr int kMessages = 50;

/// Two channels at 10 Hz, an attachment and metadata, chunks of a second.
void Write(const fs::path& file, bool finish, bool compress = true) {
  McapWriter writer(file, {.profile = "ros2", .library = "test", .compress = compress});
  writer.Attach({0, 0, "scenario.yaml", "application/yaml", std::string(300, 'y')});
  const auto schema = writer.AddSchema("a/msg/B", "ros2msg", "float64 x");
  const auto one = writer.AddChannel(schema, "/one", "cdr"),
             two = writer.AddChannel(schema, "/two", "cdr");
  RandomStream draw(7);
  for (int i = 0; i < kMessages; ++i) {
    const std::uint64_t time = 100'000'000ull * static_cast<std::uint64_t>(i);
    const std::string data = std::to_string(draw.NextBits());
    writer.Write({one, static_cast<std::uint32_t>(i), time, time, data});
    writer.Write({two, static_cast<std::uint32_t>(i), time, time, data + data});
    if (i == 30) writer.Add(McapMetadata{"half", {{"a", "b"}}});
  }
  finish ? writer.Finish() : writer.Flush();
}

struct Whole {
  std::vector<std::string> messages;
  bool complete = false;
};

Whole ReadAll(const fs::path& file) {
  McapReader reader(file);
  Whole whole;
  while (const auto message = reader.Next()) {
    whole.messages.push_back(reader.channel(message->channel_id).topic + " " +
                             std::to_string(message->log_time_ns) + " " +
                             std::string(message->data));
  }
  whole.complete = reader.complete();
  return whole;
}

TEST(McapFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const bool compress : {false, true}) {
    const fs::path file = folder.path() / "a.mcap";
    Write(file, true, compress);
    const Whole whole = ReadAll(file);
    EXPECT_TRUE(whole.complete);
    ASSERT_EQ(whole.messages.size(), 2u * kMessages);
    EXPECT_THAT(whole.messages[99], testing::StartsWith("/two 4900000000 "));
    McapReader reader(file);
    while (reader.Next()) {
    }
    ASSERT_EQ(reader.attachments().size(), 1u);
    EXPECT_EQ(reader.attachments()[0].data, std::string(300, 'y'));
    ASSERT_EQ(reader.metadata().size(), 1u);
    EXPECT_EQ(reader.metadata()[0].texts.at("a"), "b");
    EXPECT_EQ(reader.schemas().at(1).name, "a/msg/B");
    EXPECT_EQ(reader.profile(), "ros2");
  }
}

TEST(McapFile, ThatLacksItsEndGivesAllThatWasFlushed) {
  const TemporaryFolder folder;
  Write(folder.path() / "a.mcap", false);
  const Whole whole = ReadAll(folder.path() / "a.mcap");
  EXPECT_FALSE(whole.complete);
  EXPECT_EQ(whole.messages.size(), 2u * kMessages);
}

TEST(McapFile, CutAnywhereIsClosedToAFileOfItsFirstMessages) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  Write(file, true);
  const std::string bytes = Slurp(file);
  const Whole whole = ReadAll(file);
  std::size_t fewest = whole.messages.size(), most = 0;
  for (std::size_t size = bytes.size() - 1; size > 40; size -= 7) {
    WriteText(file, bytes.substr(0, size));
    const Whole torn = ReadAll(file);
    ASSERT_FALSE(torn.complete) << size;
    ASSERT_TRUE(RepairMcap(file)) << size;
    const Whole closed = ReadAll(file);
    ASSERT_TRUE(closed.complete) << size;
    ASSERT_EQ(closed.messages, torn.messages) << size;
    ASSERT_TRUE(std::equal(closed.messages.begin(), closed.messages.end(), whole.messages.begin()));
    EXPECT_FALSE(RepairMcap(file));
    fewest = std::min(fewest, closed.messages.size());
    most = std::max(most, closed.messages.size());
  }
  EXPECT_EQ(fewest, 0u);
  EXPECT_EQ(most, whole.messages.size());
}

// Nothing but the end was lost: then the end that is made anew is the one that was there.
TEST(McapFile, ThatLostItsEndGetsTheSameOneBack) {
  const TemporaryFolder folder;
  const fs::path whole = folder.path() / "a.mcap", torn = folder.path() / "b.mcap";
  Write(whole, true);
  Write(torn, false);
  EXPECT_TRUE(RepairMcap(torn));
  EXPECT_EQ(Slurp(torn), Slurp(whole));
}

TEST(McapFile, WithAnyChangedByteIsRefusedOrCutShort) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  Write(file, true);
  const std::string bytes = Slurp(file);
  RandomStream draw(3);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] ^= static_cast<char>(1 + draw.NextBits() % 255);
    WriteText(file, damaged);
    bool refused = false;
    try {
      refused = !ReadAll(file).complete;
    } catch (const DataError&) {
      refused = true;
    }
    EXPECT_TRUE(refused) << at;
  }
}

TEST(McapFile, ThatIsDamagedIsNotRepaired) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  Write(file, true);
  std::string bytes = Slurp(file);
  bytes[bytes.size() / 3] ^= 1;
  WriteText(file, bytes);
  EXPECT_THROW(RepairMcap(file), DataError);
  EXPECT_EQ(Slurp(file), bytes);
  WriteText(file, "no MCAP file");
  EXPECT_THROW(RepairMcap(file), DataError);
}

TEST(McapFile, HasChunksOfLessThanASecond) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  Write(file, true);
  const std::string bytes = Slurp(file);
  int chunks = 0;
  std::size_t at = kMcapMagic.size();
  while (static_cast<std::uint8_t>(bytes[at]) != 0x0f) {
    ByteReader record(std::string_view(bytes).substr(at));
    const std::uint8_t op = record.U8();
    ByteReader content(record.Take(record.U64()));
    at = bytes.size() - record.left();
    if (op != static_cast<std::uint8_t>(McapOp::kChunk)) continue;
    ++chunks;
    const std::uint64_t begin = content.U64();
    EXPECT_LT(content.U64() - begin, 1'000'000'000u);
  }
  EXPECT_EQ(chunks, 6);  // five seconds, and the metadata end one
}

}  // namespace
}  // namespace dockyard
