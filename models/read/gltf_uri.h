// The addresses of buffers in a glTF document (RFC 3986, 2.1): a space is written %20.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dockyard {

/// The text with each %XX as the byte that it encodes; none where a % has no two hexadecimal
/// digits behind it.
std::optional<std::string> PercentDecoded(std::string_view text);

/// The file name that a buffer's address means: a name alone, or "./" and a name, that ends in .bin
/// and leads to no other folder.
/// @returns none for any other address
std::optional<std::string> BufferNameOf(std::string_view uri);

/// The bytes of a text in base64 (RFC 4648, 4), its padding left out or not; none for another text.
std::optional<std::string> FromBase64(std::string_view text);

}  // namespace dockyard
