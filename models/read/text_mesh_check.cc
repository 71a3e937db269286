#include "models/read/text_mesh_check.h"

#include <algorithm>
#include <array>

#include "models/read/config_error.h"
#include "models/read/xml_scan.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr std::string_view kSpace = " \t\r\n", kLineEnds = "\r\n";

class Words {
 public:
  Words(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// The next word; empty at the end.
  std::string_view Next() {
    begin_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size());
    at_ = std::min(text_.find_first_of(kSpace, begin_), text_.size());
    return text_.substr(begin_, at_ - begin_);
  }
  void SkipLine() { at_ = std::min(text_.find_first_of(kLineEnds, at_), text_.size()); }

  /// Of the word taken last, or from `begin` on.
  [[noreturn]] void Refuse(const std::string& expected) const { Refuse(expected, begin_, at_); }
  [[noreturn]] void Refuse(const std::string& expected, std::size_t begin, std::size_t end) const {
    throw ConfigError(file_ + ":" + LineAndColumn(text_, begin) + ": not a usable mesh: expected " +
                      expected + ", found '" +
                      std::string(text_.substr(begin, std::min<std::size_t>(end - begin, 40))) +
                      "'");
  }

  void Expect(std::string_view word) {
    if (Next() != word) Refuse("'" + std::string(word) + "'");
  }
  void ExpectNumber() {
    double value = 0.0;
    if (!ParseNumber(Next(), value)) Refuse("a number");
  }

 private:
  std::string_view text_;
  const std::string& file_;
  std::size_t begin_ = 0, at_ = 0;
};

void CheckFacet(Words& words) {
  words.Expect("normal");
  for (int i = 0; i < 3; ++i) words.Next();
  words.Expect("outer");
  words.Expect("loop");
  for (int corner = 0; corner < 3; ++corner) {
    words.Expect("vertex");
    for (int i = 0; i < 3; ++i) words.ExpectNumber();
  }
  words.Expect("endloop");
  words.Expect("endfacet");
}

}  // namespace

void CheckStlText(std::string_view text, const std::string& file) {
  Words words(text, file);
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next()) {
    if (word != "solid") words.Refuse("'solid'");
    words.SkipLine();  // its name
    for (word = words.Next(); word != "endsolid"; word = words.Next()) {
      if (word != "facet") words.Refuse("'facet' or 'endsolid'");
      CheckFacet(words);
    }
    words.SkipLine();
  }
}

void CheckObjText(std::string_view text, const std::string& file) {
  const Words place(text, file);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find_first_not_of(kSpace, at), text.size());
    at = std::min(text.find_first_of(kLineEnds, begin), text.size());
    const std::string_view line = text.substr(begin, at - begin);
    if (line.size() < 2 || line[0] != 'v' || (line[1] != ' ' && line[1] != '\t')) continue;
    const std::string_view numbers = line.substr(1, line.find('#') - 1);
    Words words(numbers, file);
    int found = 0;
    double value = 0.0;
    for (std::string_view word = words.Next(); !word.empty(); word = words.Next(), ++found) {
      if (!ParseNumber(word, value)) place.Refuse("'v' and numbers", begin, at);
    }
    if (found != 3 && found != 4 && found != 6) {
      place.Refuse("'v' and 3, 4 or 6 numbers", begin, at);
    }
  }
}

}  // namespace dockyard
