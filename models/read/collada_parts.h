// Parts of the check of a Collada document, each over the parsed XML. All throw ConfigError.
#pragma once

#include <tinyxml.h>

#include <string>
#include <string_view>

namespace dockyard {

/// "file:line:col: <tag>: what".
[[noreturn]] void RefuseElement(const std::string& file, const TiXmlElement& at,
                                const std::string& what);
/// The element's text; it may hold nothing else.
std::string_view TextOf(const std::string& file, const TiXmlElement& element);
/// The next word of a text, taken off its front; empty at its end.
std::string_view TakeWord(std::string_view& text);
/// A whole number from 0 to 100 million; -1 for any other text.
long WholeNumber(std::string_view text);
/// An attribute that is such a number; `fallback` stands for a missing one, -1: it must be there.
long CountOf(const std::string& file, const TiXmlElement& element, const char* name,
             long fallback = -1);

/// One <mesh> of <library_geometries>.
void CheckColladaMesh(const std::string& file, const TiXmlElement& mesh);

}  // namespace dockyard
