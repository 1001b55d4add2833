#include "io/dicom/dicom_gate.h"

#include "io/messages/says.h"

#include <array>
#include <cstdio>

namespace angiopose::io {
namespace {

constexpr DicomTag itemTag = 0xfffee000;
constexpr DicomTag itemEndTag = 0xfffee00d;
constexpr DicomTag sequenceEndTag = 0xfffee0dd;
constexpr std::uint32_t undefinedLength = 0xffffffff;
constexpr int maxDepth = 32;
constexpr std::size_t maxValueBytes = std::size_t{1} << 20;   // no field that is asked for is longer

// PS3.5 §7.1.2: these have a 32-bit length, these a 16-bit one.
constexpr std::string_view longVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
constexpr std::string_view shortVrs = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}

bool isVrKnown(std::string_view vr)
{
    return longVrs.find(vr) != std::string_view::npos || shortVrs.find(vr) != std::string_view::npos;
}

std::string tagName(DicomTag tag)
{
    std::array<char, 16> buffer;
    std::snprintf(buffer.data(), buffer.size(), "(%04x,%04x)", tag >> 16, tag & 0xffff);
    return buffer.data();
}

bool isPixelTag(DicomTag tag)
{
    return tag == pixelDataTag || tag == floatPixelsTag || tag == doublePixelsTag;
}

/// Finds where values end, and whether DCMTK can be given what is in them.
class ValueWalk {
public:
    bool isClean() const { return isClean_; }

    /// Bytes of the value after `head`, delimiter included; nothing when it does not end within `rest`.
    std::optional<std::size_t> value(const ElementHead& head, std::string_view rest, DicomEncoding encoding, int depth);

private:
    std::optional<std::size_t> items(std::string_view bytes, bool isOpen, DicomEncoding encoding, bool hasElements,
                                     int depth);
    std::optional<std::size_t> elements(std::string_view bytes, bool isOpen, DicomEncoding encoding, int depth);
    void require(bool condition) { isClean_ = isClean_ && condition; }

    bool isClean_ = true;
};

std::optional<std::size_t> ValueWalk::value(const ElementHead& head, std::string_view rest, DicomEncoding encoding,
                                            int depth)
{
    const bool isOpen = head.length == undefinedLength;
    if (!isOpen && head.length > rest.size()) {
        return std::nullopt;
    }
    const std::string_view bytes = isOpen ? rest : rest.substr(0, head.length);
    const auto first = readHead(bytes, encoding);
    // Without a VR the content tells. A sequence whose VR was lost is implicit inside (PS3.5 §6.2.2).
    const bool isUnknown = head.vr.empty() || head.vr == "UN";
    const bool isSequence = head.vr == "SQ" || (isUnknown && (isOpen || (first && first->tag == itemTag)));
    require(isSequence || !isOpen);
    require(head.vr.empty() || isVrKnown(head.vr));
    if (!isSequence && !isOpen) {
        return head.length;
    }
    require(!isUnknown || encoding.order == ByteOrder::Little);
    const auto size =
        items(bytes, isOpen, isUnknown ? DicomEncoding{false, encoding.order} : encoding, isSequence, depth + 1);
    require(size.has_value());
    return isOpen ? size : head.length;
}

std::optional<std::size_t> ValueWalk::items(std::string_view bytes, bool isOpen, DicomEncoding encoding,
                                            bool hasElements, int depth)
{
    std::size_t at = 0;
    while (depth <= maxDepth && (isOpen || at < bytes.size())) {
        const auto head = readHead(bytes.substr(at), encoding);
        if (head && head->tag == sequenceEndTag && isOpen) {
            return at + head->size;
        }
        if (!head || head->tag != itemTag) {
            return std::nullopt;
        }
        at += head->size;
        const bool isOpenItem = head->length == undefinedLength;
        if (!isOpenItem && head->length > bytes.size() - at) {
            return std::nullopt;
        }
        if (hasElements || isOpenItem) {
            const auto size = elements(bytes.substr(at, head->length), isOpenItem, encoding, depth);
            require(size.has_value());
            if (isOpenItem && !size) {
                return std::nullopt;
            }
            at += isOpenItem ? *size : head->length;
        } else {
            at += head->length;
        }
    }
    return depth <= maxDepth ? std::optional(at) : std::nullopt;
}

std::optional<std::size_t> ValueWalk::elements(std::string_view bytes, bool isOpen, DicomEncoding encoding, int depth)
{
    std::size_t at = 0;
    while (isOpen || at < bytes.size()) {
        const auto head = readHead(bytes.substr(at), encoding);
        if (!head) {
            return std::nullopt;
        }
        at += head->size;
        if (head->tag == itemEndTag) {
            require(isOpen);
            return at;
        }
        require(!encoding.isExplicit || !head->vr.empty());
        const auto size = value(*head, bytes.substr(at), encoding, depth);
        if (!size) {
            return std::nullopt;
        }
        at += *size;
    }
    return at;
}

/// What one element of the data set adds.
void pass(const ElementHead& head, std::string_view whole, const ValueWalk& walk, DicomEncoding encoding,
          PassedElements& passed)
{
    const std::string_view value = whole.substr(head.size);
    if (isPixelTag(head.tag)) {
        passed.pixels.emplace(head.tag, DicomPixels{value, head.length == undefinedLength, encoding.order});
        return;
    }
    const DicomTag group = head.tag >> 16;
    const bool isOfStandard = group % 2 == 0 && group >= 0x0008;
    const bool isSequence = head.vr == "SQ" || head.length == undefinedLength;
    if (walk.isClean() && isOfStandard && (isSequence || value.size() <= maxValueBytes)) {
        (encoding.isExplicit && head.vr.empty() ? passed.withoutVr : passed.elements) += whole;
    }
}

}   // namespace

std::optional<ElementHead> readHead(std::string_view bytes, DicomEncoding encoding)
{
    if (bytes.size() < 8) {
        return std::nullopt;
    }
    ElementHead head;
    head.size = 8;
    head.tag =
        static_cast<DicomTag>(readUint16(bytes, encoding.order)) << 16 | readUint16(bytes.substr(2), encoding.order);
    // Item tags have no VR; some writers forget the VR of single elements, which the letters tell.
    if (!encoding.isExplicit || head.tag >> 16 == 0xfffe || !isUpper(bytes[4]) || !isUpper(bytes[5])) {
        head.length = readUint32(bytes.substr(4), encoding.order);
        return head;
    }
    head.vr = bytes.substr(4, 2);
    if (longVrs.find(head.vr) == std::string_view::npos) {
        head.length = readUint16(bytes.substr(6), encoding.order);
        return head;
    }
    head.size = 12;
    if (bytes.size() < head.size) {
        return std::nullopt;
    }
    head.length = readUint32(bytes.substr(8), encoding.order);
    return head;
}

PassedElements passElements(std::string_view bytes, DicomEncoding encoding)
{
    PassedElements passed;
    while (const auto head = readHead(bytes, encoding)) {
        if (head->tag == itemEndTag || head->tag == sequenceEndTag) {
            return passed;
        }
        const std::string_view rest = bytes.substr(head->size);
        const bool isOpen = head->length == undefinedLength;
        ValueWalk walk;
        auto size = walk.value(*head, rest, encoding, 0);
        if (!size && isOpen && !isPixelTag(head->tag)) {
            passed.damage = says::dicomSequenceWithoutEnd(tagName(head->tag));
            return passed;
        }
        if (!size && !isOpen) {
            passed.damage = says::dicomElementTooLong(tagName(head->tag), std::size_t{head->length}, rest.size());
        }
        passed.isEmpty = false;
        const std::string_view whole = bytes.substr(0, head->size + size.value_or(rest.size()));
        if (size || isPixelTag(head->tag)) {
            pass(*head, whole, walk, encoding, passed);
        }
        bytes.remove_prefix(whole.size());
        if (passed.damage) {
            return passed;
        }
    }
    if (bytes.find_first_not_of('\0') != std::string_view::npos) {
        passed.damage = says::dicomEndsWithin();
    }
    return passed;
}

std::optional<std::vector<std::string_view>> fragmentsOf(const DicomPixels& pixels)
{
    std::vector<std::string_view> fragments;
    std::string_view rest = pixels.bytes;
    while (const auto head = readHead(rest, DicomEncoding{true, pixels.order})) {
        rest.remove_prefix(head->size);
        if (head->tag != itemTag) {
            return head->tag == sequenceEndTag ? std::optional(fragments) : std::nullopt;
        }
        if (head->length > rest.size()) {
            return std::nullopt;
        }
        fragments.push_back(rest.substr(0, head->length));
        rest.remove_prefix(head->length);
    }
    return fragments;   // without a delimiter: whole fragments up to the end of the file
}

}   // namespace angiopose::io
