#include "io/volume/nifti.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/volume/nifti_header.h"
#include "io/volume/volume_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace angiopose::io {
namespace {

constexpr int labelIntent = 1002;

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

std::optional<core::Message> findUnsupported(const NiftiHeader& header)
{
    const std::int64_t dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7) {
        return says::volumeHeaderDimensions(dimensions);
    }
    std::int64_t volumes = 1;
    for (std::size_t i = 4; i <= static_cast<std::size_t>(dimensions); ++i) {
        volumes = std::max(volumes, header.dim[i]);
    }
    if (volumes > 1) {
        return says::volumeSeveralNifti(volumes);
    }
    if (header.datatype == 128 || header.datatype == 2304) {
        return says::volumeColours();
    }
    if (!typeOf(header.datatype)) {
        return says::volumeNiftiType(header.datatype);
    }
    if (!(header.dataOffset >= 0.0 && header.dataOffset < 1e9)) {
        return says::volumeImpossibleStart();
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
NiftiMap mapOf(const NiftiHeader& header, core::Messages& warnings)
{
    NiftiMap qform = qformOf(header);
    const bool hasQform = header.qformCode > 0 && isInvertible(qform);
    const bool hasSform = header.sformCode > 0 && isInvertible(header.sform);
    if (hasQform && hasSform) {
        const bool isAtlas = header.sformCode > 2 && header.qformCode <= 2;
        if (largestDifference(qform, header.sform, header) > 0.5) {
            warnings.emplace_back(isAtlas ? says::niftiQformUsed() : says::niftiSformUsed());
        }
        return isAtlas ? qform : header.sform;
    }
    if (hasSform) {
        return header.sform;
    }
    if (!hasQform) {
        warnings.push_back(says::volumeVoxelsAssumed());
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

}   // namespace

bool looksLikeNifti(std::string_view head)
{
    return niftiVersionOf(head) != NiftiVersion::None;
}

core::Result<StoredVolume> parseNifti(std::string_view head, StreamPacking packing, const std::string& path)
{
    const auto parsed = niftiHeaderOf(head);
    if (!parsed) {
        return fileError(path, says::volumeAnalyze());
    }
    const NiftiHeader& header = *parsed;
    if (const auto problem = findUnsupported(header)) {
        return fileError(path, *problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = header.version == NiftiVersion::One ? "NIfTI-1" : "NIfTI-2";
    const auto clamped = [](std::int64_t value) {
        return static_cast<int>(std::clamp<std::int64_t>(value, 0, 1 << 30));
    };
    const Eigen::Vector3i size(clamped(header.dim[1]), header.dim[0] > 1 ? clamped(header.dim[2]) : 1,
                               header.dim[0] > 2 ? clamped(header.dim[3]) : 1);
    const NiftiMap map = mapOf(header, stored.warnings) * millimetresPerUnit(header.units);
    const AxesResult axes = geometryFromSteps(size, lpsFromRas(Eigen::Matrix3d(map.leftCols<3>())),
                                              lpsFromRas(Eigen::Vector3d(map.col(3))));
    if (axes.problem) {
        return fileError(path, *axes.problem);
    }
    stored.geometry = axes.geometry;
    stored.type = *typeOf(header.datatype);
    stored.isBigEndian = header.isSwapped;   // of this little-endian machine
    const bool isScaled = std::isfinite(header.slope) && header.slope != 0.0 && std::isfinite(header.intercept);
    stored.slope = isScaled ? header.slope : 1.0;
    stored.intercept = isScaled ? header.intercept : 0.0;
    stored.isDeclaredLabels = header.intent == labelIntent;
    stored.source = header.isPair ? pairedSource(path) : VoxelSource{path, 0, packing};
    stored.source.skip = static_cast<std::uint64_t>(header.dataOffset);
    return stored;
}

}   // namespace angiopose::io