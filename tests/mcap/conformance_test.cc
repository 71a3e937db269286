// Files byte for byte as the format's own conformance suite has them (foxglove/mcap,
// tests/conformance/data; its sizes and the first digits of its SHA-256 are here).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "sim/mcap/mcap_reader.h"
#include "sim/mcap/mcap_writer.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

const McapOptions kPlain{.profile = "", .library = "", .compress = false};

/// Size and first eight digits of the SHA-256, by coreutils.
std::string SizeAndSha(const fs::path& file) {
  std::FILE* pipe = ::popen(("sha256sum " + file.string()).c_str(), "r");
  char digits[9] = {};
  const bool read = pipe != nullptr && std::fgets(digits, sizeof digits, pipe) != nullptr;
  char rest[4096];
  while (read && std::fgets(rest, sizeof rest, pipe) != nullptr) {
  }
  if (pipe != nullptr) ::pclose(pipe);
  return std::to_string(fs::file_size(file)) + " " + digits;
}

std::string Written(const std::function<void(McapWriter&)>& write) {
  const TemporaryFolder folder;
  McapWriter writer(folder.path() / "a.mcap", kPlain);
  write(writer);
  writer.Finish();
  McapReader reader(folder.path() / "a.mcap");
  while (reader.Next()) {
  }
  EXPECT_TRUE(reader.complete());
  return SizeAndSha(folder.path() / "a.mcap");
}

TEST(McapConformance, NoData) {
  EXPECT_EQ(Written([](McapWriter&) {}), "156 78aed997");
}

TEST(McapConformance, OneMessageInAChunkWithItsIndexes) {
  EXPECT_EQ(Written([](McapWriter& writer) {
              const auto schema = writer.AddSchema("Example", "c", "\x04\x05\x06");
              const auto channel = writer.AddChannel(schema, "example", "a", {{"foo", "bar"}});
              writer.Write({channel, 10, 2, 1, "\x01\x02\x03"});
            }),
            "603 c2dc0d4e");
}

TEST(McapConformance, OneAttachment) {
  EXPECT_EQ(Written([](McapWriter& writer) {
              writer.Attach({2, 1, "myFile", "application/octet-stream", "\x01\x02\x03"});
            }),
            "347 14c5896f");
}

TEST(McapConformance, OneMetadata) {
  EXPECT_EQ(Written([](McapWriter& writer) {
              writer.Add(McapMetadata{"myMetadata", {{"foo", "bar"}}});
            }),
            "262 6d7681e1");
}

}  // namespace
}  // namespace dockyard
