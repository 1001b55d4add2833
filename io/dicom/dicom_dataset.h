#pragma once

#include "io/support/byte_order.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

class DcmElement;
class DcmItem;

namespace angiopose::io {

using DicomTag = std::uint32_t;   ///< group number in the upper 16 bits, for example 0x00281053

std::string tagText(DicomTag tag);   ///< for example "(0028,1053)"

/// Encoding of elements as determined by the transfer syntax.
struct DicomEncoding {
    bool isExplicit = true;
    ByteOrder order = ByteOrder::Little;
};

/// Elements of a data set or a sequence item, as read by DCMTK. Cheap to copy; string views remain valid as long as any
/// copy exists. Not thread-safe, because values are converted on first access.
class DicomDataset {
public:
    DicomDataset() = default;
    explicit DicomDataset(std::shared_ptr<DcmItem> item) : layers_{std::move(item)} {}

    bool has(DicomTag tag) const { return find(tag) != nullptr; }
    std::string_view text(DicomTag tag) const;   ///< trimmed bytes as stored; empty if absent or not text
    std::string_view text(DicomTag tag, std::size_t index) const;   ///< returns one of several values separated by `\`
    std::optional<double> number(
        DicomTag tag,
        std::size_t index = 0) const;   ///< finite; interpreted by VR or, for unknown private elements, by content
    std::optional<int> integer(DicomTag tag, std::size_t index = 0) const;
    bool isBinaryNumber(DicomTag tag) const;
    std::vector<DicomDataset> items(DicomTag tag) const;   ///< items of a sequence; empty if the sequence is absent
    std::vector<DicomDataset> itemsOfAllSequences() const;

    /// Returns the underlying DCMTK items, for copying elements unchanged; the first item that contains an element
    /// takes precedence.
    const std::vector<std::shared_ptr<DcmItem>>& layers() const { return layers_; }

    /// Adds `other` as a fallback for elements that are missing in this data set.
    void addMissingFrom(const DicomDataset& other);

private:
    DcmElement* find(DicomTag tag) const;

    std::vector<std::shared_ptr<DcmItem>> layers_;   ///< the first item that contains an element takes precedence
};

/// Reads complete elements that `filterElements` has filtered. Omits elements that DCMTK cannot read.
DicomDataset readElements(std::string_view elements, DicomEncoding encoding);

}   // namespace angiopose::io
