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

/// Tag, VR and length of the element at the start of some bytes.
struct ElementHead {
    DicomTag tag = 0;
    std::string_view vr;   ///< empty when implicit, or forgotten
    std::uint32_t length = 0;
    std::size_t size = 0;   ///< bytes of the head itself
};

/// Nothing when the bytes end within the head.
std::optional<ElementHead> readHead(std::string_view bytes, DicomEncoding encoding);

/// Pixels where they lie in the file.
struct DicomPixels {
    std::string_view bytes;
    bool isEncapsulated = false;
    ByteOrder order = ByteOrder::Little;
};

/// What goes on to DCMTK, which trusts lengths and nesting: elements of the standard that lie whole within the file, no
/// deeper than 32 levels, and short plain ones of the private group in which rooms note their gantry. Other private
/// elements, long values and pixels are passed by.
struct PassedElements {
    std::string elements;
    std::string withoutVr;   ///< elements whose VR was forgotten in an explicit data set
    std::map<DicomTag, DicomPixels> pixels;
    std::optional<core::Message> damage;   ///< the first element that does not fit the file
    bool isEmpty = true;   ///< there was no element at all
};

/// Walks the elements up to the end of `bytes`, or up to the first one that is damaged.
PassedElements passElements(std::string_view bytes, DicomEncoding encoding);

/// Pieces of encapsulated pixel data, the offset table first; nothing when one is cut short.
std::optional<std::vector<std::string_view>> fragmentsOf(const DicomPixels& pixels);

}   // namespace angiopose::io
