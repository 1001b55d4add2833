#include "io/volume/open_stored_volume.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/support/silence_libraries.h"
#include "io/volume/nrrd.h"
#include "io/volume/plain_volume.h"
#include "io/volume/volume_axes.h"
#include "io/volume/voxel_stream.h"

#include <nifti2_io.h>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

namespace angiopose::io {
namespace {

/// Maps voxel indices to RAS coordinates in mm.
using NiftiMap = Eigen::Matrix<double, 3, 4>;

/// Number of header bytes that `parseNifti` requires.
constexpr std::size_t niftiHeadSize = 544;
constexpr std::size_t longestName = 80;
constexpr std::uint64_t maxExtensionBytes = 1U << 20U;   // bytes; sufficient for a table of several thousand labels

/// Header fields that are used, for all versions of the format.
struct NiftiHeader {
    std::string version;
    std::array<std::int64_t, 8> dim{};
    std::array<double, 8> pixdim{};
    int datatype = 0;
    int bitsPerVoxel = 0;
    double dataOffset = 0.0;
    double slope = 0.0;
    double intercept = 0.0;
    int intent = 0;
    int units = 0;
    int qformCode = 0;
    int sformCode = 0;
    NiftiMap qform;
    NiftiMap sform;
    bool isPair = false;
    bool isSwapped = false;
};

/// Copies the fields from the raw header structure, which is in native byte order.
template <class Raw>
NiftiHeader fieldsOf(const Raw& raw)
{
    NiftiHeader header;
    for (std::size_t i = 0; i < 8; ++i) {
        header.dim[i] = raw.dim[i];
        header.pixdim[i] = static_cast<double>(raw.pixdim[i]);
    }
    header.datatype = raw.datatype;
    header.bitsPerVoxel = raw.bitpix;
    header.dataOffset = static_cast<double>(raw.vox_offset);
    header.slope = static_cast<double>(raw.scl_slope);
    header.intercept = static_cast<double>(raw.scl_inter);
    header.intent = raw.intent_code;
    header.units = raw.xyzt_units;
    header.qformCode = raw.qform_code;
    header.sformCode = raw.sform_code;
    const nifti_dmat44 turned = nifti_quatern_to_dmat44(
        static_cast<double>(raw.quatern_b), static_cast<double>(raw.quatern_c), static_cast<double>(raw.quatern_d),
        static_cast<double>(raw.qoffset_x), static_cast<double>(raw.qoffset_y), static_cast<double>(raw.qoffset_z),
        header.pixdim[1], header.pixdim[2], header.pixdim[3], header.pixdim[0] < 0.0 ? -1.0 : 1.0);
    for (int k = 0; k < 4; ++k) {
        header.sform.col(k) = Eigen::Vector3d(static_cast<double>(raw.srow_x[k]), static_cast<double>(raw.srow_y[k]),
                                              static_cast<double>(raw.srow_z[k]));
        header.qform.col(k) = Eigen::Vector3d(turned.m[0][k], turned.m[1][k], turned.m[2][k]);
    }
    return header;
}

template <class Raw>
Raw rawHeader(std::string_view head)
{
    Raw raw{};
    std::memcpy(&raw, head.data(), sizeof raw);
    return raw;
}

/// Returns the NIfTI version (1 or 2, 0 for Analyze) from the first decompressed bytes of a file, in either byte order;
/// nullopt for other content.
std::optional<int> niftiVersionOf(std::string_view head)
{
    if (head.size() < sizeof(nifti_1_header) ||
        head.substr(128, 4) == "DICM") {   // the preamble of a DICOM file may look like Analyze
        return std::nullopt;
    }
    silenceLibraries();
    const int version = nifti_header_version(head.data(), head.size());
    const bool isWhole = version < 2 || head.size() >= sizeof(nifti_2_header);
    return version >= 0 && isWhole ? std::optional(version) : std::nullopt;
}

/// Returns the header of a NIfTI or Analyze file of known version.
NiftiHeader headerOf(std::string_view head, int version)
{
    const bool isSwapped = rawHeader<std::int32_t>(head) > 0xffff || rawHeader<std::int32_t>(head) < 0;
    NiftiHeader header;
    if (version == 2) {
        auto raw = rawHeader<nifti_2_header>(head);
        if (isSwapped) {
            nifti_swap_as_nifti2(&raw);
        }
        header = fieldsOf(raw);
        header.isPair = head.substr(4, 2) == "ni";
    } else {
        auto raw = rawHeader<nifti_1_header>(head);
        if (isSwapped) {
            nifti_swap_as_nifti1(&raw);
        }
        header = fieldsOf(raw);
        header.isPair = head.substr(344, 3) != "n+1";
    }
    if (version == 0) {   // Analyze uses the fields that NIfTI added for other purposes
        header.slope = 0.0;
        header.units = header.intent = header.qformCode = header.sformCode = 0;
        header.dataOffset = std::isfinite(header.dataOffset) ? std::abs(header.dataOffset) : 0.0;
    }
    header.version = version == 0 ? "Analyze" : "NIfTI-" + std::to_string(version);
    header.isSwapped = isSwapped;
    return header;
}

std::optional<VoxelType> typeOf(int datatype)
{
    using enum VoxelType;
    static const std::map<int, VoxelType> types = {
        {DT_UINT8, Uint8},   {DT_INT8, Int8},   {DT_INT16, Int16},   {DT_UINT16, Uint16},   {DT_INT32, Int32},
        {DT_UINT32, Uint32}, {DT_INT64, Int64}, {DT_UINT64, Uint64}, {DT_FLOAT32, Float32}, {DT_FLOAT64, Float64}};
    const auto found = types.find(datatype);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

std::optional<core::Message> findUnsupported(const NiftiHeader& header)
{
    const std::int64_t dimensions = header.dim[0];
    if (dimensions < 1 || dimensions > 7) {
        return messages::volumeHeaderDimensions(dimensions);
    }
    std::int64_t volumes = 1;
    for (std::size_t i = 4; i <= static_cast<std::size_t>(dimensions); ++i) {
        volumes = std::max(volumes, header.dim[i]);
    }
    if (volumes > 1) {
        return messages::volumeSeveralNifti(volumes);
    }
    if (header.datatype == 128 || header.datatype == 2304) {
        return messages::volumeColors();
    }
    if (!typeOf(header.datatype)) {
        return messages::volumeNiftiType(header.datatype);
    }
    if (!(header.dataOffset >= 0.0 && header.dataOffset < 1e9)) {
        return messages::volumeImpossibleStart();
    }
    return {};
}

/// Returns the minimum offset of the voxels: after the header and, in a single file, the four extension bytes.
std::uint64_t minOffset(const NiftiHeader& header)
{
    const bool isSecond = header.version == "NIfTI-2";
    return header.isPair ? 0 : (isSecond ? sizeof(nifti_2_header) : sizeof(nifti_1_header)) + 4;
}

double millimetersPerUnit(int units, core::Messages& warnings)
{
    switch (units & 7) {
        case 1:
            return 1000.0;
        case 3:
            return 0.001;
        case 0:
        case 2:
            return 1.0;
        default:
            warnings.push_back(messages::volumeUnitUnknown("xyzt_units = " + std::to_string(units)));
            return 1.0;
    }
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

/// Selects the sform or the qform as the map that places the voxels in the patient. Codes above 2 denote an atlas.
NiftiMap mapOf(const NiftiHeader& header, core::Messages& warnings)
{
    const NiftiMap& qform = header.qform;
    const bool hasQform = header.qformCode > 0 && isInvertible(qform);
    const bool hasSform = header.sformCode > 0 && isInvertible(header.sform);
    if (hasQform && hasSform) {
        const bool isAtlas = header.sformCode > 2 && header.qformCode <= 2;
        if (const double apart = largestDifference(qform, header.sform, header); apart > 0.5) {
            const core::Quantity apartMm = core::inMm(apart, 1);
            warnings.push_back(isAtlas ? messages::niftiQformUsed(apartMm) : messages::niftiSformUsed(apartMm));
        }
        return isAtlas ? qform : header.sform;
    }
    if (hasSform) {
        return header.sform;
    }
    if (!hasQform) {
        warnings.push_back(messages::volumeVoxelsAssumed());
        NiftiMap map = NiftiMap::Zero();
        map.diagonal() = Eigen::Vector3d(header.pixdim[1], header.pixdim[2], header.pixdim[3]);
        return map;
    }
    return qform;
}

std::string sizeText(const Eigen::Vector3d& size)
{
    const auto rounded = [](double length) { return toText(std::round(length * 1e4) / 1e4); };
    return rounded(size.x()) + " x " + rounded(size.y()) + " x " + rounded(size.z());
}

/// Warns if the header states the same property twice with different values, and names both values and the one used.
void findContradictions(const NiftiHeader& header, const NiftiMap& map, core::Messages& warnings)
{
    const Eigen::Vector3d stated(header.pixdim[1], header.pixdim[2], header.pixdim[3]);
    const Eigen::Vector3d used = map.leftCols<3>().colwise().norm();
    if (((stated.cwiseAbs() - used).array().abs() > 0.01 * used.array()).any()) {
        warnings.push_back(messages::niftiSizes(sizeText(stated), sizeText(used)));
    }
    const std::size_t bits = 8 * bytesOf(*typeOf(header.datatype));
    if (header.bitsPerVoxel > 0 && static_cast<std::size_t>(header.bitsPerVoxel) != bits) {
        warnings.push_back(
            messages::niftiBits(header.bitsPerVoxel, bits, std::string(nameOf(*typeOf(header.datatype)))));
    }
}

/// Returns the voxel file of a header file, "scan.img" for "scan.hdr"; also handles compressed files.
std::string pairedPath(const std::string& path)
{
    std::filesystem::path base(path);
    if (extensionOf(path).ends_with(".gz")) {
        base.replace_extension();
    }
    const std::string plain = base.replace_extension(".img").string();
    std::error_code failed;
    return !std::filesystem::exists(plain, failed) && std::filesystem::exists(plain + ".gz", failed) ? plain + ".gz"
                                                                                                     : plain;
}

std::string_view textBetween(std::string_view text, std::string_view before, std::string_view after)
{
    const std::size_t start = text.find(before);
    const std::size_t end = start == std::string_view::npos ? start : text.find(after, start + before.size());
    return end == std::string_view::npos ? std::string_view()
                                         : text.substr(start + before.size(), end - start - before.size());
}

/// Parses the label table of Connectome Workbench, which TotalSegmentator writes into a header extension: `<Label
/// Key="1" …><![CDATA[aorta]]></Label>`, or the name without CDATA.
LabelNames labelTable(std::string_view text)
{
    constexpr std::string_view opening = "<Label ";
    constexpr std::string_view closing = "</Label>";
    LabelNames names;
    for (std::size_t at = text.find(opening); at != std::string_view::npos; at = text.find(opening, at + 1)) {
        const std::size_t end = text.find(closing, at);
        if (end == std::string_view::npos) {
            break;
        }
        const std::string_view label = text.substr(at, end + closing.size() - at);
        const auto key = parseInteger(textBetween(label, "Key=\"", "\""));
        std::string_view name = textBetween(label, "<![CDATA[", "]]>");
        name = name.empty() ? textBetween(label, ">", "<") : name;
        if (key && !trimmed(name).empty()) {
            names.emplace(*key, trimmed(name).substr(0, longestName));
        }
    }
    return names;
}

/// Parses the header of a NIfTI volume (single file or .hdr/.img pair) with the structures of nifti_clib and converts
/// RAS to LPS; `head` is decompressed. Scanner coordinates take precedence if the file has several coordinate systems.
/// Warns if the volume has none, as is the case for all Analyze volumes.
core::Result<StoredVolume> parseNifti(std::string_view head, const std::string& path)
{
    const NiftiHeader header = headerOf(head, *niftiVersionOf(head));
    if (const auto problem = findUnsupported(header)) {
        return fileError(path, *problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = header.version;
    const auto clamped = [](std::int64_t value) {
        return static_cast<int>(std::clamp<std::int64_t>(value, 0, 1 << 30));
    };
    const Eigen::Vector3i size(clamped(header.dim[1]), header.dim[0] > 1 ? clamped(header.dim[2]) : 1,
                               header.dim[0] > 2 ? clamped(header.dim[3]) : 1);
    const NiftiMap ownMap = mapOf(header, stored.warnings);
    findContradictions(header, ownMap, stored.warnings);
    const NiftiMap map = ownMap * millimetersPerUnit(header.units, stored.warnings);
    const AxesResult axes = geometryFromSteps(size, lpsFromRas(Eigen::Matrix3d(map.leftCols<3>())),
                                              lpsFromRas(Eigen::Vector3d(map.col(3))));
    if (axes.problem) {
        return fileError(path, *axes.problem);
    }
    stored.geometry = axes.geometry;
    stored.type = *typeOf(header.datatype);
    const bool isScaled = std::isfinite(header.slope) && header.slope != 0.0 && std::isfinite(header.intercept);
    stored.slope = isScaled ? header.slope : 1.0;
    stored.intercept = isScaled ? header.intercept : 0.0;
    stored.isDeclaredLabelMap = header.intent == NIFTI_INTENT_LABEL;
    auto skip = static_cast<std::uint64_t>(header.dataOffset);
    if (const std::uint64_t least = minOffset(header); skip < least) {
        stored.warnings.push_back(messages::niftiStartWithinHeader(skip, least));
        skip = least;
    }
    if (!header.isPair && skip > head.size()) {
        stored.labelNames = labelTable(decompressedStart(path, std::min(skip, maxExtensionBytes)));
    }
    VoxelSource source{header.isPair ? pairedPath(path) : path, 0, false, skip};
    const auto content = openInputStart(source.path);
    source.isCompressed = content && content.value().view().starts_with("\x1f\x8b");
    source.isBigEndian = header.isSwapped;   // swapped relative to the little-endian host
    stored.voxels = voxelStream(stored, source);
    return stored;
}

/// Returns the first bytes of a file, decompressed if necessary.
std::string unpackedHead(std::string_view content, const std::string& path)
{
    return content.starts_with("\x1f\x8b") ? decompressedStart(path, niftiHeadSize)
                                           : std::string(content.substr(0, niftiHeadSize));
}

bool isNrrd(std::string_view content)
{
    return content.starts_with("NRRD000");
}

}   // namespace

bool isStoredVolume(const std::string& path)
{
    const auto input = openInputStart(path);
    if (!input) {
        return false;
    }
    const std::string_view content = input.value().view();
    return isNrrd(content) || niftiVersionOf(unpackedHead(content, path)) || plainFormatOf(content, path).has_value();
}

core::Result<StoredVolume> openStoredVolume(const std::string& path)
{
    const auto input = openInputStart(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (isNrrd(content)) {
        return parseNrrd(content, path);
    }
    if (const std::string head = unpackedHead(content, path); niftiVersionOf(head)) {
        return parseNifti(head, path);
    }
    if (const auto format = plainFormatOf(content, path)) {
        return openPlainVolume(*format, content, path);
    }
    const auto* found = describeContent(content);
    return fileError(path, found ? messages::volumeIsOther((*found)()) : messages::volumeUnknown());
}

}   // namespace angiopose::io
