#include "models/read/xml_scan.h"

#include <algorithm>

namespace dockyard {
namespace {

constexpr std::size_t kNowhere = std::string_view::npos;

class Scan {
 public:
  Scan(std::string_view text, const XmlLimits& limits) : text_(text), limits_(limits) {}

  std::optional<XmlFault> Run() {
    for (std::size_t at = text_.find('<'); at != kNowhere; at = text_.find('<', at)) {
      at = Skip(at);
      if (fault_) return fault_;
    }
    return std::nullopt;
  }

 private:
  bool Starts(std::size_t at, std::string_view with) const {
    return text_.substr(at, with.size()) == with;
  }
  std::size_t Fault(std::size_t at, std::string what) {
    fault_ = XmlFault{at, std::move(what)};
    return text_.size();
  }
  /// The byte after the next `end` at or after `from`.
  std::size_t After(std::size_t at, std::size_t from, std::string_view end, const char* of) {
    const std::size_t found = text_.find(end, from);
    if (found == kNowhere) return Fault(at, std::string("a ") + of + " without its end");
    return found + end.size();
  }

  /// The byte after the part that begins with the '<' at `at`.
  std::size_t Skip(std::size_t at) {
    if (++parts_ > limits_.parts) {
      return Fault(at, "more than " + std::to_string(limits_.parts) + " tags and attributes");
    }
    if (Starts(at, "<!--")) return After(at, at + 4, "-->", "comment");
    if (Starts(at, "<![CDATA[")) return After(at, at + 9, "]]>", "CDATA section");
    if (Starts(at, "<!")) return Fault(at, "XML with a DOCTYPE or another declaration is not read");
    if (Starts(at, "<?")) {
      const std::size_t end = After(at, at + 2, ">", "processing instruction");
      // Parsers differ in where one ends that has a '>' inside.
      if (!fault_ && text_[end - 2] != '?')
        Fault(at, "a processing instruction that ends in no ?>");
      return end;
    }
    if (Starts(at, "</")) {
      if (--depth_ < 0) return Fault(at, "a closing tag without an opening one");
      return After(at, at + 2, ">", "closing tag");
    }
    return SkipOpening(at);
  }

  std::size_t SkipOpening(std::size_t at) {
    const std::size_t limit = std::min(text_.size(), at + limits_.tag_bytes);
    char quote = 0;
    for (std::size_t i = at + 1; i < limit; ++i) {
      const char c = text_[i];
      if (quote != 0) {
        if (c == quote) quote = 0;
      } else if (c == '"' || c == '\'') {
        quote = c;
        ++parts_;
      } else if (c == '<') {
        return Fault(at, "a tag without its end");
      } else if (c == '>') {
        if (text_[i - 1] != '/' && ++depth_ > limits_.depth) {
          return Fault(at,
                       "elements nested deeper than " + std::to_string(limits_.depth) + " levels");
        }
        return i + 1;
      }
    }
    if (limit == text_.size()) return Fault(at, "a tag without its end");
    return Fault(at, "a tag of more than " + std::to_string(limits_.tag_bytes) + " bytes");
  }

  std::string_view text_;
  XmlLimits limits_;
  int depth_ = 0;
  std::size_t parts_ = 0;
  std::optional<XmlFault> fault_;
};

}  // namespace

std::optional<XmlFault> ScanXml(std::string_view text, const XmlLimits& limits) {
  return Scan(text, limits).Run();
}

std::string LineAndColumn(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t start = lines == 0 ? 0 : before.rfind('\n') + 1;
  return std::to_string(lines + 1) + ":" + std::to_string(before.size() - start + 1);
}

}  // namespace dockyard
