// The secret of a sealed campaign: without it nobody can tell its worlds, though the file of the
// campaign is public and its seed a small number.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

/// 128 bits that only the organiser of the campaign knows.
struct Secret {
  std::array<std::uint8_t, 16> bytes{};

  bool operator==(const Secret&) const = default;
};

/// From the system's generator (getrandom(2)). Throws IoError.
Secret NewSecret();
/// 32 hexadecimal digits.
std::string SecretText(const Secret& secret);
/// The file's 32 hexadecimal digits, white space about them left out. Throws IoError, and
/// std::invalid_argument for any other content.
Secret ReadSecret(const std::filesystem::path& file);
/// The file's secret; a missing file is made with a new one, and only its owner may read it.
/// Several programs may do so at once: all get the same. Throws as ReadSecret.
Secret ReadOrMakeSecret(const std::filesystem::path& file);

/// SHA-256 of the 16 bytes as 64 hexadecimal digits. Shown before the runs, it proves that the
/// secret was not chosen after them.
std::string Fingerprint(const Secret& secret);

/// The first 64 bits of HMAC-SHA256 (RFC 2104) under the secret, of the purpose, a zero byte and
/// the numbers, 8 bytes each, little-endian. No such value tells the secret, nor another value.
std::uint64_t SealedBits(const Secret& secret, std::string_view purpose,
                         const std::vector<std::uint64_t>& numbers);

}  // namespace dockyard
