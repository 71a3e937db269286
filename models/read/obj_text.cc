#include "models/read/obj_text.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/mesh_limits.h"
#include "models/read/mesh_text.h"

namespace dockyard {
namespace {

constexpr std::string_view kBlank = " \t", kEndsOfLine = "\r\n";

class ObjText {
 public:
  ObjText(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::string Run() {
    while (at_ < text_.size()) TakeLine();
    if (highest_ > vertices_) {
      begin_ = highest_at_;
      Refuse("corners from 1 to " + std::to_string(vertices_) + ", the vertices of the file");
    }
    if (faces_ == 0) throw ConfigError(file_ + ": not a usable mesh: an OBJ file without faces");
    return std::move(out_);
  }

 private:
  [[noreturn]] void Refuse(const std::string& expected) const {
    const std::size_t end = std::min(text_.find_first_of(kEndsOfLine, begin_), text_.size());
    RefuseMeshText(file_, text_, begin_, end, expected);
  }
  [[noreturn]] void RefuseCount(const std::string& what) const {
    throw ConfigError(file_ + ": not a usable mesh: more than " + what);
  }

  /// The text from `at_` to the end of its line, which is taken off.
  std::string_view ToLineEnd() {
    const std::size_t end = std::min(text_.find_first_of(kEndsOfLine, at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + (text_.substr(end, 2) == "\r\n" ? 2 : 1), text_.size());
    return line;
  }

  /// A line with those that continue it.
  void TakeLine() {
    const std::size_t first = text_.find_first_not_of(" \t\r\n", at_);
    begin_ = at_ = std::min(first, text_.size());
    std::string_view line = ToLineEnd();
    std::string joined;
    while (line.ends_with('\\') && at_ < text_.size()) {
      joined.append(line.substr(0, line.size() - 1));
      joined += ' ';
      line = ToLineEnd();
    }
    if (!joined.empty()) line = joined.append(line);
    line = line.substr(0, line.find('#'));
    if (line.size() < 2 || kBlank.find(line[1]) == std::string_view::npos) return;
    if (line[0] != 'v' && line[0] != 'f') return;
    SplitWords(line.substr(1));
    if (line[0] == 'v') TakeVertex();
    if (line[0] == 'f' && words_.size() >= 3) TakeFace();
  }

  void SplitWords(std::string_view line) {
    words_.clear();
    for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = line.find_first_not_of(kBlank, end);
    }
  }

  void TakeVertex() {
    double value = 0.0;
    for (std::string_view& word : words_) {
      if (word.starts_with('+')) word.remove_prefix(1);
      if (!ParseNumber(word, value)) Refuse("'v' and numbers");
    }
    const std::size_t count = words_.size();
    if (count < 3 || count == 5 || count > 7) Refuse("'v' and 3, 4, 6 or 7 numbers");
    if (++vertices_ > 3 * static_cast<long>(kMaxMeshTriangles)) {
      RefuseCount(std::to_string(3 * kMaxMeshTriangles) + " vertices");
    }
    const bool weighted = count == 4 && value != 1.0;
    out_ += 'v';
    for (std::size_t i = 0; i < (weighted ? 4u : 3u); ++i) out_.append(" ").append(words_[i]);
    out_ += '\n';
  }

  void TakeFace() {
    if (++faces_ > kMaxMeshTriangles) RefuseCount(std::to_string(kMaxMeshTriangles) + " triangles");
    out_ += 'f';
    for (const std::string_view word : words_) out_ += " " + std::to_string(VertexOf(word));
    out_ += '\n';
  }

  /// Which vertex a corner names. Its texture and normal are not read, but are numbers.
  long VertexOf(std::string_view corner) {
    std::string_view rest = corner;
    long vertex = 0;
    for (int part = 0; part < 3; ++part) {
      const std::string_view digits = rest.substr(0, rest.find('/'));
      long index = 0;
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), index);
      const bool whole = error == std::errc() && end == digits.data() + digits.size();
      if (!whole && (part == 0 || !digits.empty())) Refuse(kCorners);
      if (part == 0) vertex = index;
      if (digits.size() == rest.size()) return Absolute(vertex);
      rest.remove_prefix(digits.size() + 1);
    }
    Refuse(kCorners);
  }

  long Absolute(long index) {
    const long vertex = index < 0 ? vertices_ + 1 + index : index;
    if (vertex < 1 || index > 3 * static_cast<long>(kMaxMeshTriangles)) {
      Refuse("corners that name vertices of the file, counted from 1, or back from -1");
    }
    if (vertex > highest_) {
      highest_ = vertex;
      highest_at_ = begin_;
    }
    return vertex;
  }

  static constexpr const char* kCorners = "'f' and corners such as 7, 7/2, 7//3 or 7/2/3";

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0, begin_ = 0;  // of the next line; of this one, for messages
  std::vector<std::string_view> words_;
  long vertices_ = 0, highest_ = 0;  // the highest vertex that a face names may come after it
  std::size_t highest_at_ = 0, faces_ = 0;
  std::string out_;
};

}  // namespace

std::string SimplifiedObj(std::string_view text, const std::string& file) {
  return ObjText(text, file).Run();
}

}  // namespace dockyard
