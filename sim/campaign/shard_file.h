// The rows of a campaign as its runs end: append-only files, one for each shard.
//
// A line is the CRC-32 of its text in 8 hexadecimal digits, a comma and the text. The first line is
// JSON, which says what the file belongs to and where it was made; the second, the names of the
// columns: those of results.csv, then cpu_time_s, wall_time_s, note. Each further line is a
// finished run. A run may have several rows: one that was lost and tried again, say.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/folder.h"
#include "sim/base/json.h"
#include "sim/campaign/row_check.h"
#include "sim/log/results.h"

namespace dockyard {

/// Part `number` of `count`: every count-th run, from the number-th on.
struct Shard {
  int number = 1, count = 1;

  bool whole() const { return count == 1; }
  bool Has(std::int64_t index) const { return index % count == number - 1; }
};

/// "2/4"; none for other text.
std::optional<Shard> ShardFromText(std::string_view text);
/// shards/2-of-4.rows of a results folder.
std::filesystem::path ShardFile(const std::filesystem::path& dir, const Shard& shard);
/// Of a shard file; assumed, 1 to 100 GiB: a million rows take about 0.5 GiB.
inline constexpr std::uint64_t kMostShardBytes = std::uint64_t{16} << 30;
/// All shard files of a results folder, by name.
std::vector<std::filesystem::path> ShardFiles(const std::filesystem::path& dir);

/// Whether no program has the shard's file.
bool IsIdle(const std::filesystem::path& shard_file);

/// The row's text, without its check value.
std::string ShardRow(const FinishedRun& run, const RowColumns& columns);
/// None when the text is not exactly one row of these columns.
std::optional<FinishedRun> RowFromShard(std::string_view text, const RowColumns& columns);

/// What a shard's rows need to be found again without being read whole.
struct RowPlace : RowPlan {
  bool success = false;
  bool former = false;             // by former columns
  std::string_view outcome, text;  // text: the whole row; all within the file's bytes
};

/// A shard file in memory, as it is on the disk.
class ShardReader {
 public:
  /// Throws ResultsError for a file with another format or other columns than these or the former,
  /// and IoError.
  ShardReader(const std::filesystem::path& path, const RowColumns& columns);
  ~ShardReader();
  ShardReader(const ShardReader&) = delete;
  ShardReader& operator=(const ShardReader&) = delete;

  /// What the file belongs to; null when the line is damaged.
  const Json& header() const { return header_; }
  /// Whether an earlier program wrote it, by other columns.
  bool former() const { return former_; }
  bool ends_in_a_cut_off_line() const { return !bytes_.empty() && bytes_.back() != '\n'; }
  /// Every whole row, in the file's order. Returns the numbers of damaged lines: a last line
  /// without its newline, and those whose check value is wrong. Their runs are missing. Throws
  /// ResultsError for a whole row that makes no sense.
  std::vector<int> ForEach(const std::function<void(const RowPlace&)>& visit) const;

 private:
  std::filesystem::path path_;
  std::string_view bytes_;
  std::string columns_line_;  // of the file
  Json header_;
  int outcome_column_ = 0, success_column_ = 0, label_count_ = 0;
  bool former_ = false;
};

/// Appends rows to a shard file. One program at a time has it.
class ShardWriter {
 public:
  /// Makes the file, or goes on with one. A last line that was cut off is closed, so that the next
  /// row starts on a line of its own. Throws FolderTaken when another program has the file, and
  /// IoError.
  ShardWriter(const std::filesystem::path& path, const Json& header, const RowColumns& columns);
  ~ShardWriter();
  ShardWriter(const ShardWriter&) = delete;
  ShardWriter& operator=(const ShardWriter&) = delete;

  /// For the workers: a forked process closes it, so that the lock ends with the parent.
  int lock_descriptor() const { return lock_; }
  /// A killed program does not lose the row. Throws IoError.
  void Append(const FinishedRun& run);
  /// Call it now and then: rows are on the disk 0.2 s after they came, or 64 together, so that a
  /// power cut costs no more. Throws IoError.
  void FlushIfDue();
  void Flush();

 private:
  std::filesystem::path path_;
  const RowColumns& columns_;
  int lock_ = -1;
  std::unique_ptr<LineAppender> file_;
  int unflushed_ = 0;
  double oldest_s_ = 0.0;  // when the oldest unflushed row came
};

}  // namespace dockyard
