#include "models/read/text_mesh_check.h"

#include <algorithm>
#include <cctype>

#include "controller/base/number_text.h"
#include "models/read/mesh_text.h"

namespace dockyard {
namespace {

constexpr std::string_view kSpace = " \t\r\n", kLineEnds = "\r\n";

class StlText {
 public:
  StlText(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::string Run() {
    for (Next(); !word_.empty(); Next()) {
      if (word_ != "solid") Refuse("'solid'");
      SkipLine();  // its name
      out_ += "solid mesh\n";
      for (Next(); word_ != "endsolid" && !CutAfterAFacet(); Next()) {
        if (word_ != "facet") Refuse("'facet' or 'endsolid'");
        TakeFacet();
      }
      SkipLine();
      out_ += "endsolid mesh\n";
    }
    return std::move(out_);
  }

 private:
  /// The next word, in small letters; empty at the end.
  void Next() {
    begin_ = std::min(text_.find_first_not_of(kSpace, at_), text_.size());
    at_ = std::min(text_.find_first_of(kSpace, begin_), text_.size());
    word_.assign(text_.substr(begin_, at_ - begin_));
    std::transform(word_.begin(), word_.end(), word_.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  void SkipLine() { at_ = std::min(text_.find_first_of(kLineEnds, at_), text_.size()); }
  bool CutAfterAFacet() const { return word_.empty() && has_facets_; }

  [[noreturn]] void Refuse(const std::string& expected) const {
    RefuseMeshText(file_, text_, begin_, at_, expected);
  }

  void Expect(const char* word) {
    Next();
    if (word_ != word) Refuse("'" + std::string(word) + "'");
  }
  /// The words that close a facet; the file may end before them.
  void ExpectOrEnd(const char* word) {
    Next();
    if (!word_.empty() && word_ != word) Refuse("'" + std::string(word) + "'");
  }

  void TakeFacet() {
    Expect("normal");
    for (int i = 0; i < 3; ++i) Next();
    Expect("outer");
    Expect("loop");
    out_ += "facet normal 0 0 0\nouter loop\n";
    for (int corner = 0; corner < 3; ++corner) {
      Expect("vertex");
      out_ += "vertex";
      for (int i = 0; i < 3; ++i) {
        Next();
        double value = 0.0;
        if (word_.starts_with('+')) word_.erase(0, 1);
        if (!ParseNumber(word_, value)) Refuse("a number");
        out_ += " " + word_;
      }
      out_ += '\n';
    }
    if (at_ == text_.size()) Refuse("a line end, or the number may be cut");
    ExpectOrEnd("endloop");
    ExpectOrEnd("endfacet");
    out_ += "endloop\nendfacet\n";
    has_facets_ = true;
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t begin_ = 0, at_ = 0;
  std::string word_, out_;
  bool has_facets_ = false;
};

}  // namespace

std::string CheckedStl(std::string_view text, const std::string& file) {
  return StlText(text, file).Run();
}

}  // namespace dockyard
