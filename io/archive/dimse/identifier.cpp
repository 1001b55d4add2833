#include "io/archive/dimse/identifier.h"

#include "io/dicom/element_filter.h"

#include <algorithm>
#include <cstdint>

namespace angiopose::io {
namespace {

constexpr DicomTag characterSetTag = 0x00080005;

void appendBytes(std::string& bytes, std::uint32_t value, int size)
{
    for (int i = 0; i < size; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

bool isUidTag(DicomTag tag)
{
    return tag == 0x0020000d || tag == 0x0020000e || tag == 0x00080018 || tag == 0x00080016;
}

}   // namespace

std::string encodeIdentifier(const std::map<DicomTag, std::string>& values)
{
    auto all = values;
    const bool isUtf8 = std::ranges::any_of(values, [](const auto& value) {
        return std::ranges::any_of(value.second, [](char c) { return (c & 0x80) != 0; });
    });
    if (isUtf8) {
        all[characterSetTag] = "ISO_IR 192";
    }
    std::string bytes;
    for (const auto& [tag, value] : all) {
        const bool isOdd = value.size() % 2 != 0;
        appendBytes(bytes, tag >> 16U, 2);
        appendBytes(bytes, tag & 0xffffU, 2);
        appendBytes(bytes, static_cast<std::uint32_t>(value.size() + (isOdd ? 1 : 0)), 4);
        bytes += value;
        if (isOdd) {
            bytes += isUidTag(tag) ? '\0' : ' ';
        }
    }
    return bytes;
}

DicomDataset decodeIdentifier(std::string_view bytes)
{
    const DicomEncoding encoding{false, ByteOrder::Little};
    return readElements(filterElements(bytes, encoding).elements, encoding);
}

}   // namespace angiopose::io
