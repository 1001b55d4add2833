#include "io/volume/nifti_header.h"

#include <algorithm>
#include <bit>

namespace io {
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

NiftiHeader headerOne(std::string_view head, bool isSwapped)
{
    const HeaderReader in(head, isSwapped);
    NiftiHeader header;
    header.isSwapped = isSwapped;
    header.isPair = head.substr(344, 3) == "ni1";
    for (std::size_t i = 0; i < 8; ++i) {
        header.dim[i] = in.at<std::int16_t>(40 + 2 * i);
        header.pixdim[i] = in.at<float>(76 + 4 * i);
    }
    header.intent = in.at<std::int16_t>(68);
    header.datatype = in.at<std::int16_t>(70);
    header.dataOffset = in.at<float>(108);
    header.slope = in.at<float>(112);
    header.intercept = in.at<float>(116);
    header.units = in.at<std::uint8_t>(123);
    header.qformCode = in.at<std::int16_t>(252);
    header.sformCode = in.at<std::int16_t>(254);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        header.quaternion[row] = in.at<float>(256 + 4 * i);
        header.quaternionOffset[row] = in.at<float>(268 + 4 * i);
        for (std::size_t k = 0; k < 4; ++k) {
            header.sform(row, static_cast<Eigen::Index>(k)) = in.at<float>(280 + 16 * i + 4 * k);
        }
    }
    return header;
}

NiftiHeader headerTwo(std::string_view head, bool isSwapped)
{
    const HeaderReader in(head, isSwapped);
    NiftiHeader header;
    header.isSwapped = isSwapped;
    header.isPair = head.substr(4, 2) == "ni";
    for (std::size_t i = 0; i < 8; ++i) {
        header.dim[i] = in.at<std::int64_t>(16 + 8 * i);
        header.pixdim[i] = in.at<double>(104 + 8 * i);
    }
    header.datatype = in.at<std::int16_t>(12);
    header.dataOffset = static_cast<double>(in.at<std::int64_t>(168));
    header.slope = in.at<double>(176);
    header.intercept = in.at<double>(184);
    header.qformCode = in.at<std::int32_t>(344);
    header.sformCode = in.at<std::int32_t>(348);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        header.quaternion[row] = in.at<double>(352 + 8 * i);
        header.quaternionOffset[row] = in.at<double>(376 + 8 * i);
        for (std::size_t k = 0; k < 4; ++k) {
            header.sform(row, static_cast<Eigen::Index>(k)) = in.at<double>(400 + 32 * i + 8 * k);
        }
    }
    header.units = in.at<std::int32_t>(500);
    header.intent = in.at<std::int32_t>(504);
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
    NiftiHeader header = version == NiftiVersion::One ? headerOne(head, isSwapped) : headerTwo(head, isSwapped);
    header.version = version;
    return header;
}

}   // namespace io
