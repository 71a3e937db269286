// A scan of XML text before a parser sees it. The parsers behind it (TinyXML, and pugixml inside
// assimp) recurse over nested elements and compare every attribute of a tag with all others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dockyard {

struct XmlLimits {
  int depth = 64;                // elements open at once
  std::size_t tag_bytes = 8192;  // of one tag, its attributes included
  std::size_t parts = 1u << 20;  // tags and quoted attributes of the document
};

/// Where and why the text was refused.
struct XmlFault {
  std::size_t at = 0;  // byte offset
  std::string what;
};

/// The first fault, in one pass: a limit exceeded, a DOCTYPE, a tag or comment without its end, a
/// closing tag without an opening one. Comments, CDATA and quoted attributes count as text. Whether
/// the names of tags match is left to the parser.
std::optional<XmlFault> ScanXml(std::string_view text, const XmlLimits& limits = {});

/// "line:column" of a byte, both from 1.
std::string LineAndColumn(std::string_view text, std::size_t at);

}  // namespace dockyard
