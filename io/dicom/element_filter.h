#pragma once

#include "core/support/message.h"
#include "io/dicom/dicom_dataset.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

inline constexpr DicomTag floatPixelsTag = 0x7fe00008;
inline constexpr DicomTag doublePixelsTag = 0x7fe00009;
inline constexpr DicomTag pixelDataTag = 0x7fe00010;

/// Tag, VR and length of an element.
struct ElementHeader {
    DicomTag tag = 0;
    std::string_view vr;   ///< value representation; empty if implicit or omitted
    std::uint32_t length = 0;
    std::size_t size = 0;   ///< size of tag, VR and length, bytes
};

/// Reads the element header at the start of `bytes`; returns nullopt if it is truncated.
std::optional<ElementHeader> readElementHeader(std::string_view bytes, DicomEncoding encoding);

/// Range of the file that contains pixel data.
struct DicomPixels {
    std::string_view bytes;
    bool isEncapsulated = false;
    ByteOrder order = ByteOrder::Little;
};

/// Elements that are safe to pass to DCMTK, which does not verify lengths and nesting: complete standard elements
/// nested at most 32 levels deep, and short non-sequence elements of the private group in which some systems store the
/// gantry position. Other private elements, long values and pixels are skipped.
struct FilteredElements {
    std::string elements;
    std::string withoutVr;   ///< elements that have no VR although the data set is explicit
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< describes the first element that extends past the end of the file
    bool isEmpty = true;   ///< whether no element was found
};

/// Filters the elements up to the end of `bytes` or to the first damaged element.
FilteredElements filterElements(std::string_view bytes, DicomEncoding encoding);

/// Returns the fragments of encapsulated pixel data, the offset table first; nullopt if one is truncated.
std::optional<std::vector<std::string_view>> fragmentsOf(const DicomPixels& pixels);

}   // namespace angiopose::io
