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

using DicomTag = std::uint32_t;   ///< group in the upper half: 0x00281053

std::string tagText(DicomTag tag);   ///< "(0028,1053)"

/// How elements are written; fixed by the transfer syntax.
struct DicomEncoding {
    bool isExplicit = true;
    ByteOrder order = ByteOrder::Little;
};

/// Elements of a data set or of a sequence item, as DCMTK reads them. Cheap to copy; texts last as long as any copy.
/// For one thread at a time: values are converted when first asked for.
class DicomDataset {
public:
    DicomDataset() = default;
    explicit DicomDataset(std::shared_ptr<DcmItem> item) : layers_{std::move(item)} {}

    bool has(DicomTag tag) const { return find(tag) != nullptr; }
    std::string_view text(DicomTag tag) const;   ///< trimmed bytes as stored; empty when absent or no text
    std::string_view text(DicomTag tag, std::size_t index) const;   ///< one of several values (`\` between them)
    std::optional<double> number(DicomTag tag,
                                 std::size_t index = 0) const;   ///< finite, by VR; of unknown private ones by content
    std::optional<int> integer(DicomTag tag, std::size_t index = 0) const;
    bool isBinaryNumber(DicomTag tag) const;
    std::vector<DicomDataset> items(DicomTag tag) const;   ///< of a sequence; empty when absent
    std::vector<DicomDataset> itemsOfAllSequences() const;

    /// What it is made of, for those that copy elements as they are; the first that has an element gives it.
    const std::vector<std::shared_ptr<DcmItem>>& layers() const { return layers_; }

    /// Elements that are not here come from `other` from now on.
    void addMissingFrom(const DicomDataset& other);

private:
    DcmElement* find(DicomTag tag) const;

    std::vector<std::shared_ptr<DcmItem>> layers_;   ///< the first that has an element gives it
};

/// Whole elements as `passElements` lets them through. What DCMTK cannot read is left out.
DicomDataset readElements(std::string_view elements, DicomEncoding encoding);

}   // namespace angiopose::io
