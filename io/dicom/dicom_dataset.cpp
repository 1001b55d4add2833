#include "io/dicom/dicom_dataset.h"

#include "io/support/numbers.h"
#include "io/support/silence_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <array>
#include <cmath>
#include <cstdio>

namespace angiopose::io {
namespace {

DcmTagKey keyOf(DicomTag tag)
{
    return {static_cast<Uint16>(tag >> 16U), static_cast<Uint16>(tag & 0xffffU)};
}

E_TransferSyntax syntaxOf(DicomEncoding encoding)
{
    if (!encoding.isExplicit) {
        return encoding.order == ByteOrder::Big ? EXS_BigEndianImplicit : EXS_LittleEndianImplicit;
    }
    return encoding.order == ByteOrder::Big ? EXS_BigEndianExplicit : EXS_LittleEndianExplicit;
}

/// Reads a number through one of DCMTK's getters; returns nothing if `index` is past the last value.
template <class Number>
std::optional<double> valueBy(OFCondition (DcmElement::*get)(Number&, unsigned long), DcmElement& element,
                              std::size_t index)
{
    Number value{};
    return (element.*get)(value, index).good() ? std::optional(static_cast<double>(value)) : std::nullopt;
}

std::optional<double> binaryNumber(DcmElement& element, std::size_t index)
{
    switch (element.ident()) {
        case EVR_US:
            return valueBy(&DcmElement::getUint16, element, index);
        case EVR_SS:
            return valueBy(&DcmElement::getSint16, element, index);
        case EVR_UL:
        case EVR_up:   // offset within a DICOMDIR
            return valueBy(&DcmElement::getUint32, element, index);
        case EVR_SL:
            return valueBy(&DcmElement::getSint32, element, index);
        case EVR_FL:
            return valueBy(&DcmElement::getFloat32, element, index);
        case EVR_FD:
            return valueBy(&DcmElement::getFloat64, element, index);
        case EVR_AT: {
            DcmTagKey key;
            return element.getTagVal(key, index).good()
                       ? std::optional(static_cast<double>(key.getGroup()) * 65536.0 + key.getElement())
                       : std::nullopt;
        }
        default:
            return std::nullopt;
    }
}

/// Returns one of several values separated by `\`; empty if `index` is past the last value.
std::string_view valueAt(std::string_view values, std::size_t index)
{
    for (; index > 0; --index) {
        const std::size_t separator = values.find('\\');
        if (separator == std::string_view::npos) {
            return {};
        }
        values.remove_prefix(separator + 1);
    }
    return trimmed(values.substr(0, values.find('\\')));
}

/// Reads a number from a private element of unknown VR: as text, or as the binary type that the length suggests (little
/// endian, PS3.5 §6.2.2).
std::optional<double> unknownNumber(DcmElement& element, std::size_t index)
{
    Uint8* bytes = nullptr;
    if (!element.getUint8Array(bytes).good() || !bytes) {
        return std::nullopt;
    }
    const std::string_view content(reinterpret_cast<const char*>(bytes), element.getLength());
    if (content.find_first_not_of("0123456789+-.eE \\") == std::string_view::npos) {
        return parseNumber(valueAt(content, index));
    }
    const auto byteAt = [&](std::size_t at) { return static_cast<std::uint32_t>(bytes[at]); };
    if (content.size() == 2 && index == 0) {
        return byteAt(0) | byteAt(1) << 8U;
    }
    const std::size_t at = 4 * index;
    if (content.size() % 4 != 0 || at + 4 > content.size()) {
        return std::nullopt;
    }
    const std::uint32_t bits = byteAt(at) | byteAt(at + 1) << 8U | byteAt(at + 2) << 16U | byteAt(at + 3) << 24U;
    return static_cast<std::int32_t>(bits);
}

bool isBinaryVr(DcmEVR vr)
{
    return vr == EVR_US || vr == EVR_SS || vr == EVR_UL || vr == EVR_up || vr == EVR_SL || vr == EVR_FL || vr == EVR_FD;
}

/// Appends the items of a sequence; each appended item keeps the data set in memory.
void appendItems(DcmElement& element, const std::shared_ptr<DcmItem>& owner, std::vector<DicomDataset>& items)
{
    if (element.ident() != EVR_SQ) {
        return;
    }
    auto& sequence = static_cast<DcmSequenceOfItems&>(element);
    for (unsigned long i = 0; i < sequence.card(); ++i) {
        items.emplace_back(std::shared_ptr<DcmItem>(owner, sequence.getItem(i)));
    }
}

}   // namespace

std::string tagText(DicomTag tag)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "(%04x,%04x)", tag >> 16U, tag & 0xffffU);
    return text.data();
}

DcmElement* DicomDataset::find(DicomTag tag) const
{
    DcmElement* element = nullptr;
    for (const auto& layer : layers_) {
        if (layer->findAndGetElement(keyOf(tag), element).good()) {
            return element;
        }
    }
    return nullptr;
}

std::string_view DicomDataset::text(DicomTag tag) const
{
    DcmElement* element = find(tag);
    char* bytes = nullptr;
    Uint32 size = 0;
    const bool isText = element && element->getString(bytes, size).good() && bytes;
    return isText ? trimmed({bytes, size}) : std::string_view();
}

std::string_view DicomDataset::text(DicomTag tag, std::size_t index) const
{
    return valueAt(text(tag), index);
}

std::optional<double> DicomDataset::number(DicomTag tag, std::size_t index) const
{
    DcmElement* element = find(tag);
    const bool isBinary = element && (isBinaryVr(element->ident()) || element->ident() == EVR_AT);
    const bool isUnknown = element && (tag >> 16U) % 2 == 1 && text(tag).empty() && !isBinary;
    const auto value = isBinary    ? binaryNumber(*element, index)
                       : isUnknown ? unknownNumber(*element, index)
                                   : parseNumber(text(tag, index));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> DicomDataset::integer(DicomTag tag, std::size_t index) const
{
    const auto value = number(tag, index);
    return value && std::abs(*value) < 2e9 ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

bool DicomDataset::isBinaryNumber(DicomTag tag) const
{
    const DcmElement* element = find(tag);
    return element && isBinaryVr(element->ident());
}

std::vector<DicomDataset> DicomDataset::items(DicomTag tag) const
{
    std::vector<DicomDataset> items;
    for (const auto& layer : layers_) {
        DcmElement* element = nullptr;
        if (layer->findAndGetElement(keyOf(tag), element).good()) {
            appendItems(*element, layer, items);
            break;
        }
    }
    return items;
}

std::vector<DicomDataset> DicomDataset::itemsOfAllSequences() const
{
    std::vector<DicomDataset> items;
    for (const auto& layer : layers_) {
        for (unsigned long i = 0; i < layer->card(); ++i) {
            appendItems(*layer->getElement(i), layer, items);
        }
    }
    return items;
}

void DicomDataset::addMissingFrom(const DicomDataset& other)
{
    layers_.insert(layers_.end(), other.layers_.begin(), other.layers_.end());
}

DicomDataset readElements(std::string_view elements, DicomEncoding encoding)
{
    silenceLibraries();
    dcmEnableUnknownVRConversion.set(OFTrue);   // writers use VR UN for elements they do not know
    const auto data = std::make_shared<DcmDataset>();
    DcmInputBufferStream stream;
    stream.setBuffer(elements.data(), static_cast<offile_off_t>(elements.size()));
    stream.setEos();
    data->transferInit();
    data->read(stream, syntaxOf(encoding));   // keeps the elements read before an error
    data->transferEnd();
    return DicomDataset(data);
}

}   // namespace angiopose::io
