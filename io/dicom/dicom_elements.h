#pragma once

#include "io/dicom/dicom_dataset.h"

namespace angiopose::io {

inline constexpr DicomTag itemTag = 0xfffee000;
inline constexpr DicomTag itemEndTag = 0xfffee00d;
inline constexpr DicomTag sequenceEndTag = 0xfffee0dd;
inline constexpr DicomTag pixelDataTag = 0x7fe00010;
inline constexpr std::uint32_t undefinedLength = 0xffffffff;

/// Tag, VR and length of the element at the start of some bytes.
struct ElementHead {
    DicomTag tag = 0;
    std::array<char, 2> vr{'U', 'N'};
    std::uint32_t length = 0;
    std::size_t size = 0;   ///< bytes of the head itself
};

/// Nothing when the bytes end within the head.
std::optional<ElementHead> readHead(std::string_view bytes, DicomEncoding encoding);

/// Bytes from after the head of an element of undefined length to after its delimiter; nothing when it never ends.
std::optional<std::size_t> undefinedValueSize(std::string_view bytes, DicomEncoding encoding, int depth = 0);

/// The same for an item of undefined length.
std::optional<std::size_t> undefinedItemSize(std::string_view bytes, DicomEncoding encoding, int depth = 0);

}   // namespace angiopose::io