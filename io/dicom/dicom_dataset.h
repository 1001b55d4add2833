#pragma once

#include "core/support/message.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

using DicomTag = std::uint32_t;   ///< group in the upper half: 0x00281053

/// How values are written; fixed by the transfer syntax.
struct DicomEncoding {
    bool isExplicit = true;
    bool isBigEndian = false;
};

/// One data element; its value points into the file's bytes.
struct DicomElement {
    std::array<char, 2> vr{'U', 'N'};   ///< "UN" when implicit
    std::string_view value;
    bool hasUndefinedLength = false;   ///< sequence, or encapsulated pixel data
    DicomEncoding encoding;
};

/// Elements of one data set or sequence item by tag.
struct DicomDataset {
    std::map<DicomTag, DicomElement> elements;

    const DicomElement* find(DicomTag tag) const;
    std::string_view text(DicomTag tag) const;   ///< trimmed bytes as stored; empty when absent
    std::string_view text(DicomTag tag, std::size_t index) const;   ///< one of several values (`\` between them)
    std::optional<double> number(DicomTag tag, std::size_t index = 0) const;   ///< finite, text or binary by VR
    std::optional<int> integer(DicomTag tag, std::size_t index = 0) const;
    std::vector<DicomDataset> items(DicomTag tag) const;   ///< of a sequence; empty when absent or damaged
};

/// What reading elements came to.
struct DicomParse {
    DicomDataset dataset;
    std::optional<core::Message> problem;   ///< the first element that does not fit the file
};

/// Elements up to the end of `bytes`, or up to the first one that is damaged. Never reads past what is there.
DicomParse parseElements(std::string_view bytes, DicomEncoding encoding);

/// Pieces of encapsulated pixel data, the offset table first; nothing when one is cut short.
std::optional<std::vector<std::string_view>> fragmentsOf(const DicomElement& pixelData);

/// Unsigned value at `bytes` in the encoding's byte order; the caller has checked the size.
std::uint16_t readUint16(std::string_view bytes, DicomEncoding encoding);
std::uint32_t readUint32(std::string_view bytes, DicomEncoding encoding);

}   // namespace angiopose::io