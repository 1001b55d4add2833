#include "io/dicom/element_filter.h"

#include "io/dicom/siemens_tags.h"
#include "io/messages/messages.h"

#include <array>
#include <cstdio>

namespace angiopose::io {
namespace {

constexpr DicomTag itemTag = 0xfffee000;
constexpr DicomTag itemEndTag = 0xfffee00d;
constexpr DicomTag sequenceEndTag = 0xfffee0dd;
constexpr std::uint32_t undefinedLength = 0xffffffff;
constexpr std::size_t maxDepth = 32;
constexpr std::size_t maxValueBytes = std::size_t{1} << 20;   // longer than any field that is read
constexpr std::size_t maxPrivateBytes = 64;   // sufficient for numbers and the names of private blocks

// VRs with a 32-bit length field, followed by those with a 16-bit length field (PS3.5 §7.1.2).
constexpr std::string_view longVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
constexpr std::string_view shortVrs = "AE AS AT CS DA DS DT FD FL IS LO LT PN SH SL SS ST TM UI UL US";

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
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

/// Returns whether the element is the Directory Record Sequence of a DICOMDIR. Its records are read one by one
/// elsewhere, because DCMTK 3.6.7 corrects record types while reading and throws for two values that are too long.
bool isDirectory(const ElementHeader& head)
{
    return head.tag == 0x00041220;
}

/// Returns whether DCMTK interprets the encoding of the element correctly.
bool isReadable(const ElementHeader& head, DicomEncoding encoding)
{
    const bool isVrKnown =
        longVrs.find(head.vr) != std::string_view::npos || shortVrs.find(head.vr) != std::string_view::npos;
    return encoding.isExplicit ? !head.vr.empty() && isVrKnown : head.vr.empty();
}

/// Sequence or item whose end has not been reached yet.
struct OpenLevel {
    std::size_t end;   ///< upper bound of the level's end, within the enclosing level
    bool isDelimited;   ///< whether the length is undefined, so that a delimiter before `end` closes the level
    DicomEncoding encoding;
    bool holdsItems;
    bool isOpaque;   ///< whether the items are pixel fragments
};

/// Returns the nested level that an element's value opens; nullopt if the value has no nested elements. The value is at
/// the start of `rest`; `rest` ends at `end`, where the enclosing level ends.
std::optional<OpenLevel> levelOf(const ElementHeader& head, std::string_view rest, std::size_t end,
                                 DicomEncoding encoding)
{
    const bool isOpen = head.length == undefinedLength;
    const bool isUnknown = head.vr.empty() || head.vr == "UN";   // in which case the content decides
    const auto first = isUnknown && !isOpen ? readElementHeader(rest.substr(0, head.length), encoding) : std::nullopt;
    const bool isSequence = head.vr == "SQ" || (isUnknown && (isOpen || (first && first->tag == itemTag)));
    if (!isSequence && !isOpen) {
        return std::nullopt;
    }
    // A sequence of unknown VR is encoded implicitly (PS3.5 §6.2.2).
    return OpenLevel{isOpen ? end : end - rest.size() + head.length, isOpen,
                     isUnknown ? DicomEncoding{false, encoding.order} : encoding, true,
                     !isSequence || isPixelTag(head.tag)};
}

/// Size of an element's value, and whether the value is safe to pass to DCMTK.
struct ValueExtent {
    std::optional<std::size_t> size;   ///< nothing if the value extends past the available bytes
    bool isClean = true;
};

/// Walks to the end of a sequence, including all nested levels.
ValueExtent skipSequence(const OpenLevel& sequence, std::string_view bytes)
{
    ValueExtent walk;
    std::size_t at = 0;
    for (std::vector<OpenLevel> levels{sequence}; !levels.empty();) {
        const OpenLevel level = levels.back();
        if (at == level.end && !level.isDelimited) {
            levels.pop_back();
            continue;
        }
        const auto head = readElementHeader(bytes.substr(at, level.end - at), level.encoding);
        if (!head || levels.size() > 2 * maxDepth) {
            return {};
        }
        at += head->size;
        if (head->tag == itemEndTag || head->tag == sequenceEndTag) {
            if (!level.isDelimited || level.holdsItems != (head->tag == sequenceEndTag)) {
                return {};
            }
            levels.pop_back();
            continue;
        }
        const bool isOpen = head->length == undefinedLength;
        const bool isItem = head->tag == itemTag;
        if (isItem != level.holdsItems || (!isOpen && head->length > level.end - at)) {
            return {};
        }
        const std::string_view rest = bytes.substr(at, level.end - at);
        auto inside = isItem ? std::nullopt : levelOf(*head, rest, level.end, level.encoding);
        if (isItem && (isOpen || !level.isOpaque)) {
            inside = OpenLevel{isOpen ? level.end : at + head->length, isOpen, level.encoding, false, false};
        }
        walk.isClean = walk.isClean && (isItem || isReadable(*head, level.encoding)) && !(inside && inside->isOpaque) &&
                       !isDirectory(*head);
        if (inside) {
            levels.push_back(*inside);
        } else {
            at += head->length;
        }
    }
    walk.size = at;
    return walk;
}

ValueExtent walkValue(const ElementHeader& head, std::string_view rest, DicomEncoding encoding)
{
    const bool isOpen = head.length == undefinedLength;
    if (!isOpen && head.length > rest.size()) {
        return {};
    }
    const auto level = levelOf(head, rest, rest.size(), encoding);
    if (!level) {
        return {head.length, (isReadable(head, encoding) || head.vr.empty()) && !isDirectory(head)};
    }
    ValueExtent walk = skipSequence(*level, rest);
    walk.isClean = walk.isClean && walk.size && !level->isOpaque && !isDirectory(head);
    walk.size = isOpen ? walk.size : head.length;
    return walk;
}

/// Adds one element of the data set to `passed` if it is safe.
void pass(const ElementHeader& head, std::string_view whole, bool isClean, DicomEncoding encoding,
          FilteredElements& passed)
{
    const std::string_view value = whole.substr(head.size);
    if (isPixelTag(head.tag)) {
        passed.pixels.emplace(head.tag, DicomPixels{value, head.length == undefinedLength, encoding.order});
        return;
    }
    const DicomTag group = head.tag >> 16;
    const bool isOfStandard = group % 2 == 0 && group >= 0x0004;
    const bool isSequence = head.vr == "SQ" || head.length == undefinedLength;
    const bool isOfGantry = group == siemensBlock >> 16U && !isSequence && value.size() <= maxPrivateBytes;
    if (isClean && (isOfGantry || (isOfStandard && (isSequence || value.size() <= maxValueBytes)))) {
        (encoding.isExplicit && head.vr.empty() ? passed.withoutVr : passed.elements) += whole;
    }
}

}   // namespace

std::optional<ElementHeader> readElementHeader(std::string_view bytes, DicomEncoding encoding)
{
    if (bytes.size() < 8) {
        return std::nullopt;
    }
    ElementHeader head;
    head.size = 8;
    head.tag =
        static_cast<DicomTag>(readUint16(bytes, encoding.order)) << 16 | readUint16(bytes.substr(2), encoding.order);
    // Item tags have no VR, and some writers omit the VR of single elements; the two letters show whether there is one.
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

FilteredElements filterElements(std::string_view bytes, DicomEncoding encoding)
{
    FilteredElements passed;
    while (const auto head = readElementHeader(bytes, encoding)) {
        if (head->tag == itemEndTag || head->tag == sequenceEndTag) {
            return passed;
        }
        const std::string_view rest = bytes.substr(head->size);
        const bool isOpen = head->length == undefinedLength;
        const auto [size, isClean] = walkValue(*head, rest, encoding);
        if (!size && isOpen && !isPixelTag(head->tag)) {
            passed.damage = messages::dicomSequenceWithoutEnd(tagName(head->tag));
            return passed;
        }
        if (!size && !isOpen) {
            passed.damage = messages::dicomElementTooLong(tagName(head->tag), std::size_t{head->length}, rest.size());
        }
        passed.isEmpty = false;
        const std::string_view whole = bytes.substr(0, head->size + size.value_or(rest.size()));
        if (size || isPixelTag(head->tag)) {
            pass(*head, whole, isClean, encoding, passed);
        }
        bytes.remove_prefix(whole.size());
        if (passed.damage) {
            return passed;
        }
    }
    if (bytes.find_first_not_of('\0') != std::string_view::npos) {
        passed.damage = messages::dicomEndsWithin();
    }
    return passed;
}

std::optional<std::vector<std::string_view>> fragmentsOf(const DicomPixels& pixels)
{
    std::vector<std::string_view> fragments;
    std::string_view rest = pixels.bytes;
    while (const auto head = readElementHeader(rest, DicomEncoding{true, pixels.order})) {
        rest.remove_prefix(head->size);
        if (head->tag != itemTag) {
            return head->tag == sequenceEndTag ? std::optional(fragments) : std::nullopt;
        }
        if (head->length > rest.size()) {
            return fragments;
        }
        fragments.push_back(rest.substr(0, head->length));
        rest.remove_prefix(head->length);
    }
    return fragments;   // without a delimiter, all complete fragments up to the end of the file
}

}   // namespace angiopose::io
