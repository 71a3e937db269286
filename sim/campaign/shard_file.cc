#include "sim/campaign/shard_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <thread>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "sim/base/crc32.h"
#include "sim/base/text.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

constexpr std::size_t kCheckLength = 9;  // 8 digits and the comma
constexpr int kFirstLabel = 4;           // column, behind run, seed, system and controller

std::string CheckOf(std::string_view text) {
  char check[16];
  std::snprintf(check, sizeof check, "%08x,", Crc32(text));
  return check;
}

std::string Checked(std::string_view text) { return CheckOf(text) + std::string(text); }

/// The line's text; none when its check value is wrong.
std::optional<std::string_view> TextOf(std::string_view line) {
  if (line.size() < kCheckLength || line[kCheckLength - 1] != ',') return std::nullopt;
  const std::string_view text = line.substr(kCheckLength);
  if (line.substr(0, kCheckLength) != CheckOf(text)) return std::nullopt;
  return text;
}

std::vector<std::string> ShardColumnNames(const RowColumns& columns) {
  std::vector<std::string> names = ColumnNames(columns);
  for (const std::string& name : TimingNames()) names.push_back(name);
  names.push_back("note");
  return names;
}

int PlaceOf(const std::vector<std::string>& names, const char* name) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// The end of the cell that starts at `from`.
std::size_t CellEnd(std::string_view row, std::size_t from) {
  bool quoted = false;
  for (std::size_t i = from; i < row.size(); ++i) {
    if (row[i] == '"') quoted = !quoted;
    if (row[i] == ',' && !quoted) return i;
  }
  return row.size();
}

std::string_view CellAt(std::string_view row, int column) {
  std::size_t from = 0;
  for (int i = 0; i < column; ++i) from = std::min(row.size(), CellEnd(row, from) + 1);
  return row.substr(from, CellEnd(row, from) - from);
}

/// Neighbours, with the commas between them.
std::string_view CellsAt(std::string_view row, int column, int count) {
  if (count == 0) return {};
  const char* from = CellAt(row, column).data();
  const std::string_view last = CellAt(row, column + count - 1);
  return {from, static_cast<std::size_t>(last.data() + last.size() - from)};
}

template <class T>
bool ReadNumber(std::string_view text, T& value) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end && !text.empty();
}

/// Calls visit(number, line, whole) for every line until it returns false.
template <class Visit>
void VisitLines(std::string_view bytes, const Visit& visit) {
  for (int number = 1; !bytes.empty(); ++number) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const bool whole = end < bytes.size();
    if (!visit(number, bytes.substr(0, end), whole)) return;
    bytes.remove_prefix(whole ? end + 1 : end);
  }
}

bool IsHeader(std::string_view text) { return !text.empty() && text[0] == '{'; }
bool IsColumns(std::string_view text) { return text.substr(0, 4) == "run,"; }

double SecondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The results folder of a shard's file, and its place there.
Folder ResultsOf(const std::filesystem::path& path) { return path.parent_path().parent_path(); }
std::filesystem::path PlaceIn(const std::filesystem::path& path) {
  return path.parent_path().filename() / path.filename();
}

/// Takes the file for this program alone. A file system that knows no locks gives them to all.
int LockFile(const std::filesystem::path& path) {
  Descriptor lock = ResultsOf(path).OpenToWrite(PlaceIn(path), O_RDWR);
  // The worker of a program that was just killed may hold it for a moment.
  for (int tries = 0; tries < 40; ++tries) {
    if (::flock(lock.value(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
      return lock.Release();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw FolderTaken("another campaign is running in " + path.parent_path().parent_path().string() +
                    " (" + path.filename().string() + " is in use)");
}

}  // namespace

std::optional<Shard> ShardFromText(std::string_view text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, shard.count);
  if (count.ec != std::errc() || count.ptr != end) return std::nullopt;
  if (shard.number < 1 || shard.number > shard.count) return std::nullopt;
  return shard;
}

std::filesystem::path ShardFile(const std::filesystem::path& dir, const Shard& shard) {
  return dir / "shards" /
         (std::to_string(shard.number) + "-of-" + std::to_string(shard.count) + ".rows");
}

std::vector<std::filesystem::path> ShardFiles(const std::filesystem::path& dir) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : Folder(dir).Names("shards")) {
    if (name.ends_with(".rows")) files.push_back(dir / "shards" / name);
  }
  return files;
}

bool IsIdle(const std::filesystem::path& shard_file) {
  std::filesystem::path path = shard_file;
  path.replace_extension(".lock");
  const auto lock = ResultsOf(path).Open(PlaceIn(path), kMostShardBytes);
  return !lock || ::flock(lock->value(), LOCK_EX | LOCK_NB) == 0;
}

std::string ShardRow(const FinishedRun& run, const RowColumns& columns) {
  std::vector<std::string> cells = RowCells(run.result, columns);
  for (const std::string& cell : TimingCells(run.timing)) cells.push_back(cell);
  cells.push_back(OneLine(run.note));
  return CsvLine(cells);
}

std::optional<FinishedRun> RowFromShard(std::string_view text, const RowColumns& columns) {
  auto cells = SplitCsv(text);
  const std::size_t more = TimingNames().size() + 1;  // and the note
  if (!cells || cells->size() < more) return std::nullopt;
  FinishedRun run;
  run.note = std::move(cells->back());
  const auto timing =
      TimingFromCells({cells->end() - static_cast<std::ptrdiff_t>(more), cells->end() - 1});
  cells->resize(cells->size() - more);
  const auto row = RowFromCells(*cells, columns);
  if (!timing || !row) return std::nullopt;
  run.result = *row;
  run.timing = *timing;
  return run;
}

ShardReader::ShardReader(const std::filesystem::path& path, const RowColumns& columns)
    : path_(path) {
  const auto file = ResultsOf(path).Open(PlaceIn(path), kMostShardBytes);
  if (!file) throw IoError("cannot read " + path.string() + ": it is not there");
  const auto size = static_cast<std::size_t>(SizeOf(*file, path));
  void* mapped =
      size == 0 ? nullptr : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file->value(), 0);
  if (mapped == MAP_FAILED) throw IoErrorFromErrno("read", path);
  bytes_ = {static_cast<const char*>(mapped), size};
  const std::string former = CsvLine(ShardColumnNames(FormerColumns(columns)));
  label_count_ = static_cast<int>(columns.labels.size());
  VisitLines(bytes_, [&](int, std::string_view line, bool whole) {
    const auto text = whole ? TextOf(line) : std::nullopt;
    if (!text) return true;
    if (IsHeader(*text)) header_ = Json::parse(*text, nullptr, /*allow_exceptions=*/false);
    former_ = *text == former;
    return IsHeader(*text);
  });
  const std::vector<std::string> names =
      ShardColumnNames(former_ ? FormerColumns(columns) : columns);
  columns_line_ = CsvLine(names);
  outcome_column_ = PlaceOf(names, "outcome");
  success_column_ = PlaceOf(names, "docked");
}

ShardReader::~ShardReader() {
  if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

std::vector<int> ShardReader::ForEach(const std::function<void(const RowPlace&)>& visit) const {
  std::vector<int> damaged;
  VisitLines(bytes_, [&](int number, std::string_view line, bool whole) {
    const auto text = whole ? TextOf(line) : std::nullopt;
    const auto refuse = [&](const std::string& what) {
      throw ResultsError(path_.string() + ":" + std::to_string(number) + ": " + what);
    };
    if (!text) {
      damaged.push_back(number);
    } else if (IsColumns(*text)) {
      if (*text != columns_line_) refuse("expected the columns '" + columns_line_ + "'");
    } else if (!IsHeader(*text)) {
      RowPlace row;
      row.text = *text;
      row.labels = CellsAt(*text, kFirstLabel, label_count_);
      if (!ReadNumber(CellAt(*text, 0), row.run) || !ReadNumber(CellAt(*text, 1), row.seed)) {
        refuse("not a row");
      }
      row.success = CellAt(*text, success_column_) == "1";
      row.former = former_;
      row.outcome = CellAt(*text, outcome_column_);
      visit(row);
    }
    return true;
  });
  return damaged;
}

ShardWriter::ShardWriter(const std::filesystem::path& path, const Json& header,
                         const RowColumns& columns)
    : path_(path), columns_(columns) {
  DOCKYARD_CHECK(header.is_object());
  MakeFolder(ResultsOf(path).path());
  ResultsOf(path).Make(path.parent_path().filename());
  std::filesystem::path lock = path;
  lock_ = LockFile(lock.replace_extension(".lock"));
  try {
    bool headed = false, cut_off = false;
    if (ResultsOf(path).HasFile(PlaceIn(path))) {
      const ShardReader before(path, columns);
      if (before.former()) throw FolderTaken(path.string() + " has rows of an earlier program");
      headed = !before.header().is_null();
      cut_off = before.ends_in_a_cut_off_line();
    }
    file_ = std::make_unique<LineAppender>(
        ResultsOf(path).OpenToWrite(PlaceIn(path), O_WRONLY | O_APPEND), path);
    if (cut_off) file_->Append("");
    if (!headed) {
      file_->Append(Checked(header.dump()));
      file_->Append(Checked(CsvLine(ShardColumnNames(columns))));
      file_->Flush();
    }
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

ShardWriter::~ShardWriter() { ::close(lock_); }

void ShardWriter::Append(const FinishedRun& run) {
  file_->Append(Checked(ShardRow(run, columns_)));
  if (unflushed_++ == 0) oldest_s_ = SecondsNow();
  constexpr int kMostUnflushed = 64;
  if (unflushed_ >= kMostUnflushed) Flush();
}

void ShardWriter::FlushIfDue() {
  constexpr double kLongestWait_s = 0.2;
  if (unflushed_ > 0 && SecondsNow() - oldest_s_ >= kLongestWait_s) Flush();
}

void ShardWriter::Flush() {
  if (unflushed_ == 0) return;
  file_->Flush();
  unflushed_ = 0;
}

}  // namespace dockyard
