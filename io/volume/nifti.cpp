#include "io/volume/nifti.h"

#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/volume/volume_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>

namespace io {
namespace {

constexpr int labelIntent = 1002;

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

/// The fields of either version that matter here.
struct NiftiHeader {
    std::array<std::int64_t, 8> dim{};
    std::array<double, 8> pixdim{};
    int datatype = 0;
    double dataOffset = 0.0;
    double slope = 0.0;
    double intercept = 0.0;
    int intent = 0;
    int units = 0;
    int qformCode = 0;
    int sformCode = 0;
    Eigen::Vector3d quaternion;   ///< b, c, d
    Eigen::Vector3d quaternionOffset;
    Eigen::Matrix<double, 3, 4> sform;
    bool isPair = false;
    bool isSwapped = false;
};

enum class NiftiVersion { None, Analyze, One, Two };

NiftiVersion versionOf(std::string_view head, bool& isSwapped)
{
    if (head.size() < 348) {
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
    for (int i = 0; i < 3; ++i) {
        header.quaternion[i] = in.at<float>(static_cast<std::size_t>(256 + 4 * i));
        header.quaternionOffset[i] = in.at<float>(static_cast<std::size_t>(268 + 4 * i));
        for (int k = 0; k < 4; ++k) {
            header.sform(i, k) = in.at<float>(static_cast<std::size_t>(280 + 16 * i + 4 * k));
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
    for (int i = 0; i < 3; ++i) {
        header.quaternion[i] = in.at<double>(static_cast<std::size_t>(352 + 8 * i));
        header.quaternionOffset[i] = in.at<double>(static_cast<std::size_t>(376 + 8 * i));
        for (int k = 0; k < 4; ++k) {
            header.sform(i, k) = in.at<double>(static_cast<std::size_t>(400 + 32 * i + 8 * k));
        }
    }
    header.units = in.at<std::int32_t>(500);
    header.intent = in.at<std::int32_t>(504);
    return header;
}

std::optional<VoxelType> typeOf(int datatype)
{
    switch (datatype) {
        case 2:
            return VoxelType::Uint8;
        case 4:
            return VoxelType::Int16;
        case 8:
            return VoxelType::Int32;
        case 16:
            return VoxelType::Float32;
        case 64:
            return VoxelType::Float64;
        case 256:
            return VoxelType::Int8;
        case 512:
            return VoxelType::Uint16;
        case 768:
            return VoxelType::Uint32;
        case 1024:
            return VoxelType::Int64;
        case 1280:
            return VoxelType::Uint64;
        default:
            return std::nullopt;
    }
}

std::string findUnsupported(const NiftiHeader& header)
{
    const std::int64_t dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7) {
        return "its header is damaged: it names " + std::to_string(dimensions) + " dimensions. Export it again.";
    }
    std::int64_t volumes = 1;
    for (std::size_t i = 4; i <= static_cast<std::size_t>(dimensions); ++i) {
        volumes = std::max(volumes, header.dim[i]);
    }
    if (volumes > 1) {
        return "it holds " + std::to_string(volumes) +
               " volumes or values per voxel (4-D). Extract the one to use and open that.";
    }
    if (header.datatype == 128 || header.datatype == 2304) {
        return "its voxels are colours. Choose the scan itself, in grey values.";
    }
    if (!typeOf(header.datatype)) {
        return "its voxel type (NIfTI datatype " + std::to_string(header.datatype) +
               ") is not read. Save it as 16-bit or float.";
    }
    if (!(header.dataOffset >= 0.0 && header.dataOffset < 1e9)) {
        return "its header is damaged: the voxels begin at an impossible place. Export it again.";
    }
    return {};
}

double millimetresPerUnit(int units)
{
    switch (units & 7) {
        case 1:
            return 1000.0;
        case 3:
            return 0.001;
        default:
            return 1.0;
    }
}

/// RAS millimetres from voxel indices.
using NiftiMap = Eigen::Matrix<double, 3, 4>;

NiftiMap qformOf(const NiftiHeader& header)
{
    const double a = std::sqrt(std::max(0.0, 1.0 - header.quaternion.squaredNorm()));
    Eigen::Quaterniond turn(a, header.quaternion.x(), header.quaternion.y(), header.quaternion.z());
    turn.normalize();
    Eigen::Vector3d spacing(header.pixdim[1], header.pixdim[2], header.pixdim[3]);
    spacing.z() *= header.pixdim[0] < 0.0 ? -1.0 : 1.0;
    NiftiMap map;
    map.leftCols<3>() = turn.toRotationMatrix() * spacing.asDiagonal();
    map.col(3) = header.quaternionOffset;
    return map;
}

bool isInvertible(const NiftiMap& map)
{
    return map.allFinite() && std::abs(map.leftCols<3>().determinant()) > 1e-12;
}

double largestDifference(const NiftiMap& a, const NiftiMap& b, const NiftiHeader& header)
{
    double largest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector4d voxel(0.0, 0.0, 0.0, 1.0);
        for (int axis = 0; axis < 3; ++axis) {
            voxel[axis] =
                (corner >> axis & 1) != 0 ? static_cast<double>(header.dim[static_cast<std::size_t>(axis) + 1]) : 0.0;
        }
        largest = std::max(largest, ((a - b) * voxel).norm());
    }
    return largest;
}

/// Which of the two maps places the voxels in the patient. Codes above 2 mean an atlas.
NiftiMap mapOf(const NiftiHeader& header, std::vector<std::string>& warnings)
{
    const NiftiMap qform = qformOf(header);
    const bool hasQform = header.qformCode > 0 && isInvertible(qform);
    const bool hasSform = header.sformCode > 0 && isInvertible(header.sform);
    if (hasQform && hasSform) {
        const bool isAtlas = header.sformCode > 2 && header.qformCode <= 2;
        if (largestDifference(qform, header.sform, header) > 0.5) {
            warnings.push_back(std::string("Its two placements (qform and sform) differ; the ") +
                               (isAtlas ? "qform, in the scanner's coordinates, is used." : "sform is used."));
        }
        return isAtlas ? qform : header.sform;
    }
    if (hasSform) {
        return header.sform;
    }
    if (!hasQform) {
        warnings.emplace_back(
            "The header does not say how the voxels lie in the patient: +x right to left, +y front to back and +z up "
            "are assumed to be i, j reversed and k. Check left and right.");
        NiftiMap map = NiftiMap::Zero();
        map.diagonal() = Eigen::Vector3d(header.pixdim[1], header.pixdim[2], header.pixdim[3]);
        return map;
    }
    return qform;
}

/// "scan.hdr" → "scan.img", also packed.
VoxelSource pairedSource(const std::string& path)
{
    std::filesystem::path base(path);
    const bool isPacked = extensionOf(path).ends_with(".gz");
    if (isPacked) {
        base.replace_extension();
    }
    for (const char* extension : {".img", ".img.gz"}) {
        const std::string candidate = base.replace_extension().string() + extension;
        std::error_code failed;
        if (std::filesystem::exists(candidate, failed)) {
            const bool isGzip = candidate.ends_with(".gz");
            return {candidate, 0, isGzip ? StreamPacking::Deflate : StreamPacking::None};
        }
    }
    return {base.replace_extension(".img").string()};
}

void putText(std::string& header, std::size_t offset, std::string_view text)
{
    std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(offset));
}

template <class T>
void put(std::string& header, std::size_t offset, T value)
{
    std::memcpy(header.data() + offset, &value, sizeof value);
}

}   // namespace

bool looksLikeNifti(std::string_view head)
{
    bool isSwapped = false;
    return versionOf(head, isSwapped) != NiftiVersion::None;
}

core::Result<StoredVolume> parseNifti(std::string_view head, StreamPacking packing, const std::string& path)
{
    bool isSwapped = false;
    const NiftiVersion version = versionOf(head, isSwapped);
    if (version == NiftiVersion::Analyze || version == NiftiVersion::None) {
        return fileError(path,
                         "this is an Analyze 7.5 header, which does not say left from right. Convert it to NIfTI where "
                         "the orientation is known.");
    }
    const NiftiHeader header = version == NiftiVersion::One ? headerOne(head, isSwapped) : headerTwo(head, isSwapped);
    if (const std::string problem = findUnsupported(header); !problem.empty()) {
        return fileError(path, problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = version == NiftiVersion::One ? "NIfTI-1" : "NIfTI-2";
    const auto clamped = [](std::int64_t value) {
        return static_cast<int>(std::clamp<std::int64_t>(value, 0, 1 << 30));
    };
    const Eigen::Vector3i size(clamped(header.dim[1]), header.dim[0] > 1 ? clamped(header.dim[2]) : 1,
                               header.dim[0] > 2 ? clamped(header.dim[3]) : 1);
    const NiftiMap map = mapOf(header, stored.warnings) * millimetresPerUnit(header.units);
    const AxesResult axes = geometryFromSteps(size, lpsFromRas(Eigen::Matrix3d(map.leftCols<3>())),
                                              lpsFromRas(Eigen::Vector3d(map.col(3))));
    if (!axes.problem.empty()) {
        return fileError(path, axes.problem);
    }
    stored.geometry = axes.geometry;
    stored.type = *typeOf(header.datatype);
    stored.isBigEndian = isSwapped;   // of this little-endian machine
    const bool isScaled = std::isfinite(header.slope) && header.slope != 0.0 && std::isfinite(header.intercept);
    stored.slope = isScaled ? header.slope : 1.0;
    stored.intercept = isScaled ? header.intercept : 0.0;
    stored.isDeclaredLabels = header.intent == labelIntent;
    stored.source = header.isPair ? pairedSource(path) : VoxelSource{path, 0, packing};
    stored.source.skip = static_cast<std::uint64_t>(header.dataOffset);
    return stored;
}

std::string niftiHeader(const core::VolumeGeometry& geometry, double slope, double intercept, bool isLabel)
{
    std::string header(352, '\0');
    put<std::int32_t>(header, 0, 348);
    const std::array<int, 8> dim = {3, geometry.size.x(), geometry.size.y(), geometry.size.z(), 1, 1, 1, 1};
    const Eigen::Matrix3d axes = lpsFromRas(Eigen::Matrix3d(geometry.direction));   // the same flip both ways
    const double handedness = axes.determinant() < 0.0 ? -1.0 : 1.0;
    const std::array<double, 4> pixdim = {handedness, geometry.spacingMm.x(), geometry.spacingMm.y(),
                                          geometry.spacingMm.z()};
    for (std::size_t i = 0; i < 8; ++i) {
        put(header, 40 + 2 * i, static_cast<std::int16_t>(dim[i]));
        put(header, 76 + 4 * i, static_cast<float>(i < 4 ? pixdim[i] : 0.0));
    }
    put<std::int16_t>(header, 68, static_cast<std::int16_t>(isLabel ? labelIntent : 0));
    put<std::int16_t>(header, 70, static_cast<std::int16_t>(isLabel ? 512 : 4));
    put<std::int16_t>(header, 72, 16);
    put(header, 108, 352.0F);
    put(header, 112, static_cast<float>(slope));
    put(header, 116, static_cast<float>(intercept));
    put<std::uint8_t>(header, 123, 2);   // mm
    put<std::int16_t>(header, 252, 1);
    put<std::int16_t>(header, 254, 1);
    Eigen::Matrix3d turn = axes;
    turn.col(2) *= handedness;
    Eigen::Quaterniond quaternion(turn);
    if (quaternion.w() < 0.0) {
        quaternion.coeffs() *= -1.0;
    }
    const Eigen::Vector3d origin = lpsFromRas(Eigen::Vector3d(geometry.originInPatient));
    for (int i = 0; i < 3; ++i) {
        put(header, static_cast<std::size_t>(256 + 4 * i), static_cast<float>(quaternion.vec()[i]));
        put(header, static_cast<std::size_t>(268 + 4 * i), static_cast<float>(origin[i]));
        for (int k = 0; k < 4; ++k) {
            const double value = k < 3 ? axes(i, k) * geometry.spacingMm[k] : origin[i];
            put(header, static_cast<std::size_t>(280 + 16 * i + 4 * k), static_cast<float>(value));
        }
    }
    putText(header, 344, std::string_view("n+1\0", 4));
    return header;
}

}   // namespace io
