// A log written anew as other programs write MCAP files.
#pragma once

#include <filesystem>

namespace dockyard {

enum class ForeignCompression { kNone, kZstd, kZstdWithoutSize, kLz4 };

struct ForeignWriting {
  ForeignCompression compression = ForeignCompression::kNone;
  bool check_values = true;        // else 0 throughout: "not available"
  bool message_indexes = true;     // behind the chunks
  bool summary = true;             // else a footer alone
  std::size_t chunk_bytes = 4096;  // 0: no chunks, each record by itself
  bool attachments_last = false;
  bool private_records = false;  // some of another program's own in between
};

/// Writes the log of a file of ours again, with the same messages, attachments and metadata.
void RewriteForeign(const std::filesystem::path& from, const std::filesystem::path& to,
                    const ForeignWriting& writing);

}  // namespace dockyard
