#include "io/dicom/dicom_dataset.h"

#include "io/dicom/dicom_elements.h"
#include "io/messages/says.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

namespace angiopose::io {
namespace {

bool isVr(const DicomElement& element, std::string_view vr)
{
    return element.vr[0] == vr[0] && element.vr[1] == vr[1];
}

/// Without a VR: most of group 0028 is binary 16-bit, the rest of what we read is text (PS3.6).
bool isImplicitShort(DicomTag tag)
{
    constexpr std::array<DicomTag, 7> texts = {0x00280004, 0x00280008, 0x00280030, 0x00280034,
                                               0x00280a02, 0x00281040, 0x00281090};
    const bool isRescale = tag >= 0x00281050 && tag <= 0x00281055;
    return tag >> 16 == 0x0028 && !isRescale && std::find(texts.begin(), texts.end(), tag) == texts.end();
}

template <class Number>
std::optional<double> binaryValue(const DicomElement& element, std::size_t index)
{
    const std::size_t size = sizeof(Number);
    if (element.value.size() < (index + 1) * size) {
        return std::nullopt;
    }
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(element.value.data() + index * size, size, bytes.begin());
    if (element.encoding.isBigEndian) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return static_cast<double>(std::bit_cast<Number>(bytes));
}

std::optional<double> valueOf(DicomTag tag, const DicomElement& element, std::size_t index, std::string_view text)
{
    const bool isUnknown = isVr(element, "UN");
    if (isVr(element, "US") || (isUnknown && isImplicitShort(tag))) {
        return binaryValue<std::uint16_t>(element, index);
    }
    if (isVr(element, "SS")) {
        return binaryValue<std::int16_t>(element, index);
    }
    if (isVr(element, "UL")) {
        return binaryValue<std::uint32_t>(element, index);
    }
    if (isVr(element, "SL")) {
        return binaryValue<std::int32_t>(element, index);
    }
    if (isVr(element, "FL")) {
        return binaryValue<float>(element, index);
    }
    if (isVr(element, "FD")) {
        return binaryValue<double>(element, index);
    }
    return parseNumber(text);
}

std::string tagName(DicomTag tag)
{
    std::array<char, 16> buffer;
    std::snprintf(buffer.data(), buffer.size(), "(%04x,%04x)", tag >> 16, tag & 0xffff);
    return buffer.data();
}

DicomEncoding insideOf(const DicomElement& element)
{
    // A sequence whose VR was lost is implicit inside (PS3.5 §6.2.2).
    return isVr(element, "UN") ? DicomEncoding{false, element.encoding.isBigEndian} : element.encoding;
}

}   // namespace

const DicomElement* DicomDataset::find(DicomTag tag) const
{
    const auto found = elements.find(tag);
    return found == elements.end() ? nullptr : &found->second;
}

std::string_view DicomDataset::text(DicomTag tag) const
{
    const DicomElement* element = find(tag);
    return element && !element->hasUndefinedLength ? trimmed(element->value) : std::string_view();
}

std::string_view DicomDataset::text(DicomTag tag, std::size_t index) const
{
    std::string_view rest = text(tag);
    for (; index > 0; --index) {
        const std::size_t separator = rest.find('\\');
        if (separator == std::string_view::npos) {
            return {};
        }
        rest.remove_prefix(separator + 1);
    }
    return trimmed(rest.substr(0, rest.find('\\')));
}

std::optional<double> DicomDataset::number(DicomTag tag, std::size_t index) const
{
    const DicomElement* element = find(tag);
    const auto value = element ? valueOf(tag, *element, index, text(tag, index)) : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> DicomDataset::integer(DicomTag tag, std::size_t index) const
{
    const auto value = number(tag, index);
    return value && std::abs(*value) < 2e9 ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::vector<DicomDataset> DicomDataset::items(DicomTag tag) const
{
    std::vector<DicomDataset> result;
    const DicomElement* element = find(tag);
    if (!element) {
        return result;
    }
    const DicomEncoding encoding = insideOf(*element);
    std::string_view rest = element->value;
    while (const auto head = readHead(rest, encoding)) {
        rest.remove_prefix(head->size);
        if (head->tag != itemTag) {
            break;
        }
        std::size_t size = head->length;
        if (head->length == undefinedLength) {
            const auto found = undefinedItemSize(rest, encoding);
            if (!found) {
                break;
            }
            size = *found;
            result.push_back(parseElements(rest.substr(0, size), encoding).dataset);
        } else if (size <= rest.size()) {
            result.push_back(parseElements(rest.substr(0, size), encoding).dataset);
        } else {
            break;
        }
        rest.remove_prefix(size);
    }
    return result;
}

DicomParse parseElements(std::string_view bytes, DicomEncoding encoding)
{
    DicomParse parse;
    while (const auto head = readHead(bytes, encoding)) {
        bytes.remove_prefix(head->size);
        if (head->tag == itemEndTag || head->tag == sequenceEndTag) {
            return parse;
        }
        DicomElement element{head->vr, {}, head->length == undefinedLength, encoding};
        std::size_t size = head->length;
        if (element.hasUndefinedLength) {
            const bool isPixels = head->tag == pixelDataTag;
            const auto found = undefinedValueSize(bytes, isPixels ? encoding : insideOf(element));
            size = found.value_or(bytes.size());
            if (!found && !isPixels) {
                parse.problem = says::dicomSequenceWithoutEnd(tagName(head->tag));
                return parse;
            }
        } else if (size > bytes.size()) {
            parse.problem = says::dicomElementTooLong(tagName(head->tag), size, bytes.size());
            element.value = bytes;
            parse.dataset.elements.emplace(head->tag, element);
            return parse;
        }
        element.value = bytes.substr(0, size);
        parse.dataset.elements.emplace(head->tag, element);
        bytes.remove_prefix(size);
    }
    if (bytes.find_first_not_of('\0') != std::string_view::npos) {
        parse.problem = says::dicomEndsWithin();
    }
    return parse;
}

std::optional<std::vector<std::string_view>> fragmentsOf(const DicomElement& pixelData)
{
    std::vector<std::string_view> fragments;
    std::string_view rest = pixelData.value;
    while (const auto head = readHead(rest, pixelData.encoding)) {
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