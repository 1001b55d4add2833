#include "io/volume/nifti_header.h"

#include <algorithm>
#include <bit>

namespace angiopose::io {
namespace {

/// Numbers at byte offsets of a header in either byte order.
class HeaderReader {
public:
    HeaderReader(std::string_view head, bool isSwapped) : head_(head), isSwapped_(isSwapped) {}

    template <class T>
    T at(std::size_t offset) const
    {
        std::array<char, sizeof(T)> bytes{};
        std::copy_n(head_.data() + offset, sizeof(T), bytes.begin());
        if (isSwapped_) {
            std::reverse(bytes.begin(), bytes.end());
        }
        return std::bit_cast<T>(bytes);
    }

private:
    std::string_view head_;
    bool isSwapped_;
};

NiftiVersion versionOf(std::string_view head, bool& isSwapped)
{
    if (head.size() < 348 || head.substr(128, 4) == "DICM") {   // the preamble of a DICOM file may look like Analyze
        return NiftiVersion::None;
    }
    for (const bool swapped : {false, true}) {
        const auto size = HeaderReader(head, swapped).at<std::int32_t>(0);
        isSwapped = swapped;
        if (size == 540 && head.size() >= 540 && (head.substr(4, 2) == "n+" || head.substr(4, 2) == "ni")) {
            return NiftiVersion::Two;
        }
        if (size == 348) {
            const std::string_view magic = head.substr(344, 3);
            return magic == "n+1" || magic == "ni1" ? NiftiVersion::One : NiftiVersion::Analyze;
        }
    }
    return NiftiVersion::None;
}

/// Where each version keeps its numbers, and of which types they are.
struct LayoutOne {
    using Dim = std::int16_t;
    using Code = std::int16_t;
    using Units = std::uint8_t;
    using Offset = float;
    using Real = float;
    static constexpr std::string_view pairMagic = "ni1";
    static constexpr std::size_t magic = 344, dim = 40, pixdim = 76, intent = 68, datatype = 70, dataOffset = 108,
                                 slope = 112, intercept = 116, units = 123, qformCode = 252, sformCode = 254,
                                 quaternion = 256, quaternionOffset = 268, sform = 280;
};

struct LayoutTwo {
    using Dim = std::int64_t;
    using Code = std::int32_t;
    using Units = std::int32_t;
    using Offset = std::int64_t;
    using Real = double;
    static constexpr std::string_view pairMagic = "ni";
    static constexpr std::size_t magic = 4, dim = 16, pixdim = 104, intent = 504, datatype = 12, dataOffset = 168,
                                 slope = 176, intercept = 184, units = 500, qformCode = 344, sformCode = 348,
                                 quaternion = 352, quaternionOffset = 376, sform = 400;
};

template <class Layout>
NiftiHeader headerIn(std::string_view head, bool isSwapped)
{
    using Real = typename Layout::Real;
    constexpr std::size_t realBytes = sizeof(Real);
    const HeaderReader in(head, isSwapped);
    NiftiHeader header;
    header.isSwapped = isSwapped;
    header.isPair = head.substr(Layout::magic, Layout::pairMagic.size()) == Layout::pairMagic;
    for (std::size_t i = 0; i < 8; ++i) {
        header.dim[i] = in.at<typename Layout::Dim>(Layout::dim + sizeof(typename Layout::Dim) * i);
        header.pixdim[i] = in.at<Real>(Layout::pixdim + realBytes * i);
    }
    header.intent = in.at<typename Layout::Code>(Layout::intent);
    header.datatype = in.at<std::int16_t>(Layout::datatype);
    header.dataOffset = static_cast<double>(in.at<typename Layout::Offset>(Layout::dataOffset));
    header.slope = in.at<Real>(Layout::slope);
    header.intercept = in.at<Real>(Layout::intercept);
    header.units = in.at<typename Layout::Units>(Layout::units);
    header.qformCode = in.at<typename Layout::Code>(Layout::qformCode);
    header.sformCode = in.at<typename Layout::Code>(Layout::sformCode);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        header.quaternion[row] = in.at<Real>(Layout::quaternion + realBytes * i);
        header.quaternionOffset[row] = in.at<Real>(Layout::quaternionOffset + realBytes * i);
        for (std::size_t k = 0; k < 4; ++k) {
            header.sform(row, static_cast<Eigen::Index>(k)) = in.at<Real>(Layout::sform + realBytes * (4 * i + k));
        }
    }
    return header;
}

}   // namespace

NiftiVersion niftiVersionOf(std::string_view head)
{
    bool isSwapped = false;
    return versionOf(head, isSwapped);
}

std::optional<NiftiHeader> niftiHeaderOf(std::string_view head)
{
    bool isSwapped = false;
    const NiftiVersion version = versionOf(head, isSwapped);
    if (version != NiftiVersion::One && version != NiftiVersion::Two) {
        return std::nullopt;
    }
    NiftiHeader header =
        version == NiftiVersion::One ? headerIn<LayoutOne>(head, isSwapped) : headerIn<LayoutTwo>(head, isSwapped);
    header.version = version;
    return header;
}

}   // namespace angiopose::io