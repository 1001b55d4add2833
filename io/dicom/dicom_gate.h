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
struct ElementHead {
    DicomTag tag = 0;
    std::string_view vr;   ///< empty if implicit or omitted
    std::uint32_t length = 0;
    std::size_t size = 0;   ///< size of the head itself, bytes
};

/// Reads the head at the start of `bytes`; nothing if the bytes end within it.
std::optional<ElementHead> readHead(std::string_view bytes, DicomEncoding encoding);

/// Pixel data as a range of the file.
struct DicomPixels {
    std::string_view bytes;
    bool isEncapsulated = false;
    ByteOrder order = ByteOrder::Little;
};

/// Elements that are safe to pass to DCMTK, which trusts lengths and nesting: complete standard elements at most 32
/// levels deep, and short plain elements of the private group in which some systems store the gantry position. Other
/// private elements, long values and pixels are skipped.
struct PassedElements {
    std::string elements;
    std::string withoutVr;   ///< elements without a VR in an explicit data set
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< the first element that extends beyond the file
    bool isEmpty = true;   ///< no element was found
};

/// Filters the elements up to the end of `bytes` or the first damaged element.
PassedElements passElements(std::string_view bytes, DicomEncoding encoding);

/// Fragments of encapsulated pixel data, the offset table first; nothing if one is truncated.
std::optional<std::vector<std::string_view>> fragmentsOf(const DicomPixels& pixels);

}   // namespace angiopose::io
