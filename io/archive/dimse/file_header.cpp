#include "io/archive/dimse/file_header.h"

#include <cstdint>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr const char* implementationClass = "2.25.277613902894205893846702311409541530624";
constexpr const char* implementationVersion = "ANGIOPOSE";

void appendLittle(std::string& bytes, std::size_t value, int size)
{
    for (int i = 0; i < size; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

/// Explicit VR, little endian; of group 0002.
void appendMeta(std::string& bytes, std::uint16_t element, std::string_view vr, std::string value, char padding = '\0')
{
    if (value.size() % 2 != 0) {
        value += padding;
    }
    appendLittle(bytes, 0x0002, 2);
    appendLittle(bytes, element, 2);
    bytes += vr;
    if (vr == "OB") {
        appendLittle(bytes, 0, 2);
        appendLittle(bytes, value.size(), 4);
    } else {
        appendLittle(bytes, value.size(), 2);
    }
    bytes += value;
}

}   // namespace

std::string encodedHeader(const FileHeader& header)
{
    std::string meta;
    appendMeta(meta, 0x0001, "OB", std::string("\0\1", 2));
    appendMeta(meta, 0x0002, "UI", header.sopClass);
    appendMeta(meta, 0x0003, "UI", header.sopInstance);
    appendMeta(meta, 0x0010, "UI", header.transferSyntax);
    appendMeta(meta, 0x0012, "UI", implementationClass);
    appendMeta(meta, 0x0013, "SH", implementationVersion, ' ');
    if (!header.sourceTitle.empty()) {
        appendMeta(meta, 0x0016, "AE", header.sourceTitle, ' ');
    }
    std::string length, bytes(128, '\0');
    appendLittle(length, meta.size(), 4);
    bytes += "DICM";
    appendMeta(bytes, 0x0000, "UL", length);
    return bytes + meta;
}

}   // namespace angiopose::io
