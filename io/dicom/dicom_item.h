#pragma once

#include "core/support/result.h"
#include "io/dicom/dicom_dataset.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

class DcmFileFormat;

namespace angiopose::io {

/// Writes elements into a DICOM object or a sequence item, replacing existing ones. The caller specifies each VR by its
/// two letters, so no data dictionary is required. Valid as long as the object exists.
class DicomItem {
public:
    explicit DicomItem(DcmItem& item) : item_(&item) {}

    void text(DicomTag tag, const char* vr, const std::string& value);   ///< may be empty; `\` separates values
    void setTextIfAbsent(DicomTag tag, const char* vr, const std::string& value);
    void setDecimals(DicomTag tag, const std::vector<double>& values);   ///< VR DS, as precise as 16 characters permit
    void setUnsignedShort(DicomTag tag, int value);
    void setUnsignedShorts(DicomTag tag, const std::vector<std::uint16_t>& values);   ///< no values: no element
    void setSignedShort(DicomTag tag, int value);
    void setSignedLongs(DicomTag tag, const std::vector<std::int32_t>& values);
    void setUnsignedLongs(DicomTag tag, const std::vector<std::uint32_t>& values);
    void setFloats(DicomTag tag, const std::vector<float>& values);
    void setDoubles(DicomTag tag, const std::vector<double>& values);
    void setAttributeTag(DicomTag tag, DicomTag pointedTo);   ///< VR AT
    void words(DicomTag tag, const std::vector<std::uint16_t>& values);   ///< VR OW
    void bytes(DicomTag tag, std::string_view content);   ///< VR OB, padded to even length
    void setFloatPixels(const std::vector<float>& values);   ///< VR OF

    void remove(DicomTag tag);

    DicomItem addItem(DicomTag sequence);
    void addEmptySequence(DicomTag sequence);

    DcmItem& element() const { return *item_; }   ///< underlying DCMTK item, for copying elements unchanged

private:
    DcmItem* item_;
};

/// A DICOM object under construction.
class DicomObject {
public:
    DicomObject();
    ~DicomObject();
    DicomObject(const DicomObject&) = delete;
    DicomObject& operator=(const DicomObject&) = delete;

    DicomItem root();

    /// Returns the complete file as explicit VR little endian. Fails if an element is invalid.
    core::Result<std::string> content();

private:
    std::unique_ptr<DcmFileFormat> file_;
};

/// Truncates a UTF-8 string to the given number of characters (not bytes).
std::string truncateUtf8(std::string_view utf8, std::size_t characters);

}   // namespace angiopose::io
