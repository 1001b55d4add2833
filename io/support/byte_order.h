#pragma once

#include <cstdint>
#include <string_view>

namespace angiopose::io {

enum class ByteOrder { Little, Big };

/// Reads an unsigned number from the start of `bytes`; the caller must ensure that there are enough bytes.
inline std::uint16_t readUint16(std::string_view bytes, ByteOrder order)
{
    const auto first = static_cast<std::uint8_t>(bytes[0]);
    const auto second = static_cast<std::uint8_t>(bytes[1]);
    return static_cast<std::uint16_t>(order == ByteOrder::Big ? first << 8 | second : second << 8 | first);
}

inline std::uint32_t readUint32(std::string_view bytes, ByteOrder order)
{
    const std::uint32_t first = readUint16(bytes, order);
    const std::uint32_t second = readUint16(bytes.substr(2), order);
    return order == ByteOrder::Big ? first << 16 | second : second << 16 | first;
}

}   // namespace angiopose::io
