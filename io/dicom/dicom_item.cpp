#include "io/dicom/dicom_item.h"

#include "io/dicom/stored_values.h"
#include "io/messages/messages.h"
#include "io/support/silence_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>

namespace angiopose::io {
namespace {

DcmTag writtenTag(DicomTag tag, const DcmVR& vr)
{
    return {static_cast<Uint16>(tag >> 16U), static_cast<Uint16>(tag & 0xffffU), vr};
}

}   // namespace

void DicomItem::text(DicomTag tag, const char* vr, const std::string& value)
{
    item_->putAndInsertString(writtenTag(tag, DcmVR(vr)), value.c_str());
}

void DicomItem::setTextIfAbsent(DicomTag tag, const char* vr, const std::string& value)
{
    if (!item_->tagExists(writtenTag(tag, DcmVR(vr)))) {
        text(tag, vr, value);
    }
}

void DicomItem::setDecimals(DicomTag tag, const std::vector<double>& values)
{
    std::string joined;
    for (const double value : values) {
        joined += (joined.empty() ? "" : "\\") + decimalString(value);
    }
    text(tag, "DS", joined);
}

void DicomItem::setUnsignedShort(DicomTag tag, int value)
{
    item_->putAndInsertUint16(writtenTag(tag, EVR_US), static_cast<Uint16>(value));
}

void DicomItem::setUnsignedShorts(DicomTag tag, const std::vector<std::uint16_t>& values)
{
    if (!values.empty()) {
        item_->putAndInsertUint16Array(writtenTag(tag, EVR_US), values.data(), values.size());
    }
}

void DicomItem::setSignedShort(DicomTag tag, int value)
{
    item_->putAndInsertSint16(writtenTag(tag, EVR_SS), static_cast<Sint16>(value));
}

void DicomItem::setSignedLongs(DicomTag tag, const std::vector<std::int32_t>& values)
{
    auto* element = new DcmSignedLong(writtenTag(tag, EVR_SL));
    element->putSint32Array(values.data(), values.size());
    item_->insert(element, OFTrue);
}

void DicomItem::setUnsignedLongs(DicomTag tag, const std::vector<std::uint32_t>& values)
{
    auto* element = new DcmUnsignedLong(writtenTag(tag, EVR_UL));
    element->putUint32Array(values.data(), values.size());
    item_->insert(element, OFTrue);
}

void DicomItem::setFloats(DicomTag tag, const std::vector<float>& values)
{
    auto* element = new DcmFloatingPointSingle(writtenTag(tag, EVR_FL));
    element->putFloat32Array(values.data(), values.size());
    item_->insert(element, OFTrue);
}

void DicomItem::setDoubles(DicomTag tag, const std::vector<double>& values)
{
    auto* element = new DcmFloatingPointDouble(writtenTag(tag, EVR_FD));
    element->putFloat64Array(values.data(), values.size());
    item_->insert(element, OFTrue);
}

void DicomItem::setAttributeTag(DicomTag tag, DicomTag pointedTo)
{
    auto* element = new DcmAttributeTag(writtenTag(tag, EVR_AT));
    element->putTagVal(DcmTagKey(static_cast<Uint16>(pointedTo >> 16U), static_cast<Uint16>(pointedTo & 0xffffU)));
    item_->insert(element, OFTrue);
}

void DicomItem::words(DicomTag tag, const std::vector<std::uint16_t>& values)
{
    item_->putAndInsertUint16Array(writtenTag(tag, EVR_OW), values.data(), values.size());
}

void DicomItem::bytes(DicomTag tag, std::string_view content)
{
    auto* element = new DcmOtherByteOtherWord(writtenTag(tag, EVR_OB));
    element->putUint8Array(reinterpret_cast<const Uint8*>(content.data()), content.size());
    item_->insert(element, OFTrue);
}

void DicomItem::setFloatPixels(const std::vector<float>& values)
{
    auto* element = new DcmOtherFloat(writtenTag(0x7fe00008, EVR_OF));
    element->putFloat32Array(values.data(), values.size());
    item_->insert(element, OFTrue);
}

void DicomItem::remove(DicomTag tag)
{
    delete item_->remove(DcmTagKey(static_cast<Uint16>(tag >> 16U), static_cast<Uint16>(tag & 0xffffU)));
}

DicomItem DicomItem::addItem(DicomTag sequence)
{
    constexpr long atTheEnd = -2;
    DcmItem* item = nullptr;
    item_->findOrCreateSequenceItem(writtenTag(sequence, EVR_SQ), item, atTheEnd);
    return DicomItem(*item);
}

void DicomItem::addEmptySequence(DicomTag sequence)
{
    item_->insert(new DcmSequenceOfItems(writtenTag(sequence, EVR_SQ)), OFTrue);
}

DicomObject::DicomObject()
{
    silenceLibraries();
    file_ = std::make_unique<DcmFileFormat>();
}

DicomObject::~DicomObject() = default;

DicomItem DicomObject::root()
{
    return DicomItem(*file_->getDataset());
}

core::Result<std::string> DicomObject::content()
{
    std::string content;
    std::vector<char> buffer(std::size_t{1} << 20);
    DcmOutputBufferStream stream(buffer.data(), static_cast<offile_off_t>(buffer.size()));
    file_->transferInit();
    OFCondition state = EC_StreamNotifyClient;
    while (state == EC_StreamNotifyClient) {   // repeat while the output buffer is full
        state = file_->write(stream, EXS_LittleEndianExplicit, EET_ExplicitLength, nullptr);
        void* bytes = nullptr;
        offile_off_t size = 0;
        stream.flushBuffer(bytes, size);
        content.append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
    }
    file_->transferEnd();
    return state.good() ? core::Result<std::string>(std::move(content)) : core::Error(messages::dicomNotWritten());
}

std::string truncateUtf8(std::string_view utf8, std::size_t characters)
{
    std::size_t end = 0;
    for (; end < utf8.size(); ++end) {
        const bool isStart = (static_cast<unsigned char>(utf8[end]) & 0xc0U) != 0x80U;
        if (isStart && characters-- == 0) {
            break;
        }
    }
    return std::string(utf8.substr(0, end));
}

}   // namespace angiopose::io
