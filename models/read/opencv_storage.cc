#include "models/read/opencv_storage.h"

#include <algorithm>
#include <cctype>
#include <memory>

#include "models/read/config_error.h"
#include "models/read/xml_scan.h"

namespace dockyard {
namespace {

constexpr int kMostDepth = 32;
constexpr int kMostNodes = 200000;

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

class XmlTree {
 public:
  XmlTree(const std::string& text, const std::string& file)
      : text_(text), source_(std::make_shared<const std::string>(file)) {}

  YamlNode Root() {
    SkipProlog();
    const YamlPlace place = Here();
    std::string name;
    YamlNode root = Element(name, 0);
    if (name != "opencv_storage") {
      Refuse(place, "expected OpenCV's <opencv_storage>, found <" + name + ">");
    }
    if (root.kind != YamlNode::Kind::kMapping) Refuse(place, "expected elements, found none");
    return root;
  }

 private:
  [[noreturn]] static void Refuse(const YamlPlace& place, const std::string& why) {
    throw ConfigError(place.Text() + ": " + why);
  }
  bool Starts(const char* with) const {
    return text_.compare(at_, std::string(with).size(), with) == 0;
  }
  bool AtEnd() const { return at_ >= text_.size(); }
  void Step() {
    if (text_[at_++] == '\n') {
      ++line_;
      column_ = 1;
    } else if ((static_cast<unsigned char>(text_[at_ - 1]) & 0xC0) != 0x80) {
      ++column_;  // not inside a UTF-8 sequence
    }
  }
  void StepTo(std::size_t end) {
    while (at_ < std::min(end, text_.size())) Step();
  }
  YamlPlace Here() const { return {source_, line_, column_}; }
  void SkipSpace() {
    while (!AtEnd() && IsSpace(text_[at_])) Step();
  }
  void SkipPast(const char* end) {
    const std::size_t found = text_.find(end, at_);
    if (found == std::string::npos)
      Refuse(Here(), std::string("expected '") + end + "', found the end");
    StepTo(found + std::string(end).size());
  }
  /// Comments and processing instructions.
  bool SkipNote() {
    if (Starts("<!--")) return SkipPast("-->"), true;
    if (Starts("<?")) return SkipPast("?>"), true;
    return false;
  }
  void SkipProlog() {
    SkipSpace();
    while (SkipNote()) SkipSpace();
  }
  YamlNode Make(YamlNode::Kind kind, YamlPlace place) {
    if (++nodes_ > kMostNodes) {
      Refuse(place, "more than " + std::to_string(kMostNodes) + " values in one file");
    }
    YamlNode node;
    node.kind = kind;
    node.place = std::move(place);
    return node;
  }
  std::string Name() {
    const std::size_t first = at_;
    while (!AtEnd() && !IsSpace(text_[at_]) && text_[at_] != '>' && text_[at_] != '/') Step();
    return text_.substr(first, at_ - first);
  }

  YamlNode Element(std::string& name, int depth) {
    if (AtEnd() || text_[at_] != '<') Refuse(Here(), "expected an element");
    if (depth > kMostDepth) Refuse(Here(), "nested deeper than " + std::to_string(kMostDepth));
    YamlNode node = Make(YamlNode::Kind::kNull, Here());
    Step();
    name = Name();
    if (name.empty()) Refuse(node.place, "expected an element, found a tag without a name");
    while (!AtEnd() && text_[at_] != '>') Attribute();
    if (AtEnd()) Refuse(node.place, "expected the end of <" + name + ">");
    const bool closed = text_[at_ - 1] == '/';
    Step();
    if (!closed) Content(name, depth, node);
    return node;
  }
  void Attribute() {
    const char c = text_[at_];
    Step();
    if (c != '"' && c != '\'') return;
    while (!AtEnd() && text_[at_] != c) Step();
    if (!AtEnd()) Step();
  }

  void Content(const std::string& name, int depth, YamlNode& node) {
    std::vector<YamlNode> words;
    while (true) {
      SkipSpace();
      if (AtEnd()) Refuse(node.place, "expected </" + name + ">, found the end");
      if (SkipNote()) continue;
      if (Starts("</")) {
        StepTo(at_ + 2);
        if (Name() != name) Refuse(Here(), "expected </" + name + ">, found another");
        SkipPast(">");
        break;
      }
      if (text_[at_] == '<') {
        const YamlPlace place = Here();
        std::string child;
        YamlNode item = Element(child, depth + 1);
        if (std::any_of(node.keys.begin(), node.keys.end(), [&](const YamlNode::Key& key) {
              return child != "_" && key.name == child;
            })) {
          Refuse(place, child + ": given twice");
        }
        node.keys.push_back({child, place});
        node.items.push_back(std::move(item));
      } else {
        words.push_back(Word());
      }
    }
    Settle(node, std::move(words));
  }

  YamlNode Word() {
    YamlNode node = Make(YamlNode::Kind::kScalar, Here());
    node.quoted = text_[at_] == '"';
    if (node.quoted) {
      Step();
      const std::size_t end = std::min(text_.find('"', at_), text_.size());
      node.scalar = text_.substr(at_, end - at_);
      StepTo(end + 1);
      return node;
    }
    const std::size_t first = at_;
    while (!AtEnd() && !IsSpace(text_[at_]) && text_[at_] != '<') Step();
    node.scalar = text_.substr(first, at_ - first);
    return node;
  }

  /// An element's kind by what it held.
  static void Settle(YamlNode& node, std::vector<YamlNode> words) {
    if (!node.keys.empty()) {
      if (!words.empty())
        Refuse(words[0].place, "expected elements alone, found text between them");
      const bool list = std::all_of(node.keys.begin(), node.keys.end(),
                                    [](const YamlNode::Key& key) { return key.name == "_"; });
      node.kind = list ? YamlNode::Kind::kSequence : YamlNode::Kind::kMapping;
      if (list) node.keys.clear();
    } else if (words.size() == 1) {
      node = std::move(words[0]);
    } else if (words.size() > 1) {
      node.kind = YamlNode::Kind::kSequence;
      node.items = std::move(words);
    }
  }

  const std::string& text_;
  std::shared_ptr<const std::string> source_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1, nodes_ = 0;
};

}  // namespace

void BlankOpenCvMarks(std::string& text) {
  if (text.rfind("%YAML:", 0) == 0) {
    for (std::size_t i = 0; i < text.size() && text[i] != '\n' && text[i] != '\r'; ++i) {
      text[i] = ' ';
    }
  }
  const std::string tag = "!!opencv-";
  for (std::size_t at = text.find(tag); at != std::string::npos; at = text.find(tag, at)) {
    while (at < text.size() && (std::isalpha(static_cast<unsigned char>(text[at])) != 0 ||
                                text[at] == '!' || text[at] == '-')) {
      text[at++] = ' ';
    }
  }
}

YamlNode ParseOpenCvXml(const std::string& text, const std::string& file) {
  if (const auto fault = ScanXml(text)) {
    throw ConfigError(file + ":" + LineAndColumn(text, fault->at) + ": " + fault->what);
  }
  return XmlTree(text, file).Root();
}

}  // namespace dockyard
