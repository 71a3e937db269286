// CRC-32, the check value of a row that is written: a changed bit does not go unseen.
#pragma once

#include <cstdint>
#include <string_view>

namespace dockyard {

/// Of zip, PNG and IEEE 802.3: 0xcbf43926 for "123456789".
/// @param before  that of the bytes before these
std::uint32_t Crc32(std::string_view bytes, std::uint32_t before = 0);

}  // namespace dockyard
