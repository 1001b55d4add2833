#include "io/dicom/dicom_elements.h"

#include <algorithm>
#include <string_view>

namespace angiopose::io {
namespace {

constexpr int maxDepth = 32;
constexpr std::string_view longVrs = "OBODOFOLOVOWSQSVUCUNURUTUV";   // these have a 32-bit length (PS3.5 §7.1.2)

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}

bool hasLongLength(const std::array<char, 2>& vr)
{
    for (std::size_t i = 0; i < longVrs.size(); i += 2) {
        if (longVrs[i] == vr[0] && longVrs[i + 1] == vr[1]) {
            return true;
        }
    }
    return false;
}

}   // namespace

std::uint16_t readUint16(std::string_view bytes, DicomEncoding encoding)
{
    const auto first = static_cast<std::uint8_t>(bytes[0]);
    const auto second = static_cast<std::uint8_t>(bytes[1]);
    return static_cast<std::uint16_t>(encoding.isBigEndian ? first << 8 | second : second << 8 | first);
}

std::uint32_t readUint32(std::string_view bytes, DicomEncoding encoding)
{
    const std::uint32_t first = readUint16(bytes, encoding);
    const std::uint32_t second = readUint16(bytes.substr(2), encoding);
    return encoding.isBigEndian ? first << 16 | second : second << 16 | first;
}

std::optional<ElementHead> readHead(std::string_view bytes, DicomEncoding encoding)
{
    if (bytes.size() < 8) {
        return std::nullopt;
    }
    ElementHead head;
    head.tag = static_cast<DicomTag>(readUint16(bytes, encoding)) << 16 | readUint16(bytes.substr(2), encoding);
    // Item tags have no VR; some writers forget the VR of single elements, which the letters tell.
    if (!encoding.isExplicit || head.tag >> 16 == 0xfffe || !isUpper(bytes[4]) || !isUpper(bytes[5])) {
        head.length = readUint32(bytes.substr(4), encoding);
        head.size = 8;
        return head;
    }
    head.vr = {bytes[4], bytes[5]};
    if (!hasLongLength(head.vr)) {
        head.length = readUint16(bytes.substr(6), encoding);
        head.size = 8;
        return head;
    }
    if (bytes.size() < 12) {
        return std::nullopt;
    }
    head.length = readUint32(bytes.substr(8), encoding);
    head.size = 12;
    return head;
}

std::optional<std::size_t> undefinedValueSize(std::string_view bytes, DicomEncoding encoding, int depth)
{
    if (depth > maxDepth) {
        return std::nullopt;
    }
    std::size_t at = 0;
    while (const auto head = readHead(bytes.substr(at), encoding)) {
        at += head->size;
        if (head->tag == sequenceEndTag) {
            return at;
        }
        if (head->tag != itemTag) {
            return std::nullopt;
        }
        if (head->length == undefinedLength) {
            const auto size = undefinedItemSize(bytes.substr(at), encoding, depth);
            if (!size) {
                return std::nullopt;
            }
            at += *size;
        } else if (head->length > bytes.size() - at) {
            return std::nullopt;
        } else {
            at += head->length;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> undefinedItemSize(std::string_view bytes, DicomEncoding encoding, int depth)
{
    std::size_t at = 0;
    while (const auto head = readHead(bytes.substr(at), encoding)) {
        at += head->size;
        if (head->tag == itemEndTag) {
            return at;
        }
        if (head->length == undefinedLength) {
            const bool isUnknown = head->vr == std::array{'U', 'N'};
            const auto size = undefinedValueSize(
                bytes.substr(at), isUnknown ? DicomEncoding{false, encoding.isBigEndian} : encoding, depth + 1);
            if (!size) {
                return std::nullopt;
            }
            at += *size;
        } else if (head->length > bytes.size() - at) {
            return std::nullopt;
        } else {
            at += head->length;
        }
    }
    return std::nullopt;
}

}   // namespace angiopose::io