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

/// Elements that are put into a DICOM object, or into an item of one of its sequences. What is there already is
/// replaced. Value representations are given by their two letters, so that no dictionary is asked. Valid as long as
/// the object.
class DicomItem {
public:
    explicit DicomItem(DcmItem& item) : item_(&item) {}

    void text(DicomTag tag, const char* vr, const std::string& value);   ///< may be empty; `\` between values
    void textWhereAbsent(DicomTag tag, const char* vr, const std::string& value);
    void decimals(DicomTag tag, const std::vector<double>& values);   ///< DS, as exact as 16 characters allow
    void unsignedShort(DicomTag tag, int value);
    void unsignedShorts(DicomTag tag, const std::vector<std::uint16_t>& values);   ///< nothing when empty
    void signedShort(DicomTag tag, int value);
    void signedLongs(DicomTag tag, const std::vector<std::int32_t>& values);
    void unsignedLongs(DicomTag tag, const std::vector<std::uint32_t>& values);
    void floats(DicomTag tag, const std::vector<float>& values);
    void doubles(DicomTag tag, const std::vector<double>& values);
    void attribute(DicomTag tag, DicomTag pointedTo);   ///< AT
    void words(DicomTag tag, const std::vector<std::uint16_t>& values);   ///< OW
    void bytes(DicomTag tag, std::string_view content);   ///< OB, made even
    void floatPixels(const std::vector<float>& values);   ///< OF

    void remove(DicomTag tag);

    DicomItem addItem(DicomTag sequence);
    void emptySequence(DicomTag sequence);

    DcmItem& element() const { return *item_; }   ///< for those that copy elements as they are

private:
    DcmItem* item_;
};

/// A DICOM object that is being made.
class DicomObject {
public:
    DicomObject();
    ~DicomObject();
    DicomObject(const DicomObject&) = delete;
    DicomObject& operator=(const DicomObject&) = delete;

    DicomItem root();

    /// The file as it would lie on disk, little endian with VRs. Fails when an element is not one.
    core::Result<std::string> content();

private:
    std::unique_ptr<DcmFileFormat> file_;
};

/// Text of at most `characters`, which may be several bytes each.
std::string shortened(std::string_view utf8, std::size_t characters);

}   // namespace angiopose::io
