// Whether a text is well-formed XML.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace dockyard {

/// Why it is not, or none: tags nest and close, attributes are quoted, no stray < & or >.
inline std::optional<std::string> XmlFault(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      if (end == std::string::npos || end - i > 6) return "stray &";
      i = end + 1;
    } else if (text[i] == '>') {
      return "stray >";
    } else if (text[i] == '<') {
      const std::size_t end = text.find('>', i);
      if (end == std::string::npos) return "a tag is not closed";
      const std::string tag = text.substr(i + 1, end - i - 1);
      if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "a quote is open: " + tag;
      if (tag.find('<') != std::string::npos) return "a tag in a tag: " + tag;
      const std::string name = tag.substr(0, tag.find(' '));
      if (name[0] == '/') {
        if (open.empty() || "/" + open.back() != name) return "closes what is not open: " + tag;
        open.pop_back();
      } else if (tag.back() != '/' && name[0] != '?') {
        open.push_back(name);
      }
      i = end + 1;
    } else {
      ++i;
    }
  }
  return open.empty() ? std::nullopt : std::optional("left open: " + open.back());
}

}  // namespace dockyard
