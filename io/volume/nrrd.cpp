#include "io/volume/nrrd.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/support/scoped_c_locale.h"
#include "io/volume/volume_axes.h"
#include "io/volume/voxel_stream.h"

#include <NrrdIO.h>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t longestSegmentName = 80;
constexpr std::size_t longestHeader = std::size_t{1} << 20;
constexpr std::size_t maxFieldBytes = 400;   // the library copies unreadable text to a fixed-size buffer

struct FreeNrrd {
    void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
    void operator()(NrrdIoState* state) const { nrrdIoStateNix(state); }
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A header as read by ITK's NRRD library.
struct NrrdHeader {
    std::unique_ptr<Nrrd, FreeNrrd> nrrd{nrrdNew()};
    std::unique_ptr<NrrdIoState, FreeNrrd> state{nrrdIoStateNew()};
    std::string problem;   ///< error text of the library; empty on success
};

/// Header text for the library, without the data file field, because the library would open that file while reading the
/// header.
struct HeaderText {
    std::string text;
    std::string dataFile;   ///< empty if the data follow the header
    int lineSkip = 0;
    int byteSkip = 0;
    std::size_t end = 0;   ///< offset in the file, after the blank line
};

/// Returns the value of a line that contains the field `name`, spelled with or without blanks; nullopt for other lines.
/// Also accepts fields that some programs write as key/value pairs (":=").
std::optional<std::string> fieldValue(std::string_view line, std::string_view name)
{
    const std::size_t colon = std::min(line.find(':'), line.size());
    std::string given = toLower(line.substr(0, colon));
    std::erase(given, ' ');
    if (colon == line.size() || given != name) {
        return std::nullopt;
    }
    line.remove_prefix(colon + 1);
    return std::string(trimmed(line.substr(line.starts_with('=') ? 1 : 0)));
}

/// Reads the lines up to the first blank line and corrects common errors of other programs: space directions without a
/// `space` field, or with vectors between vertical bars.
HeaderText splitHeader(std::string_view content)
{
    HeaderText header;
    header.end = content.size();
    const std::string_view head = content.substr(0, longestHeader);
    for (std::size_t at = 0; at < head.size() && !header.dataFile.starts_with("LIST");) {
        const std::size_t newline = std::min(head.find('\n', at), head.size());
        std::string line(head.substr(at, newline - at));
        at = newline + 1;
        if (trimmed(line).empty()) {
            header.end = std::min(at, content.size());
            break;
        }
        if (const auto file = fieldValue(line, "datafile")) {
            header.dataFile = *file;
        } else if (const auto lines = fieldValue(line, "lineskip")) {
            header.lineSkip = parseInteger(*lines).value_or(-1);
        } else if (const auto bytes = fieldValue(line, "byteskip")) {
            header.byteSkip = parseInteger(*bytes).value_or(-2);
        } else {
            if (line.starts_with("space directions") || line.starts_with("space origin")) {
                std::erase(line, '|');
            }
            const bool isField = line.find(":=") == std::string::npos;
            header.text += (isField ? line.substr(0, maxFieldBytes) : line) + "\n";
        }
    }
    std::string& text = header.text;
    const auto has = [&text](const char* start) { return text.find(start) != std::string::npos; };
    if (has("\nspace directions") && !has("\nspace:") && !has("\nspace dimension:")) {
        text.insert(text.find('\n') + 1, "space dimension: 3\n");
    }
    text += "\n";
    return header;
}

/// Returns the innermost error message of the library, without function names.
std::string lastErrorMessage(const std::string& errorMessages)
{
    const std::string_view all = trimmed(errorMessages);
    std::string_view last = all.substr(all.rfind('\n') == std::string_view::npos ? 0 : all.rfind('\n') + 1);
    last = last.substr(last.find(": ") == std::string_view::npos ? 0 : last.find(": ") + 2);
    return std::string(last.substr(0, 120));
}

NrrdHeader parsedHeader(std::string text)
{
    static std::mutex oneAtATime;   // the library stores its errors in global state
    const std::lock_guard lock(oneAtATime);
    const ScopedCLocale decimalPoint;
    NrrdHeader header;
    const std::unique_ptr<std::FILE, FreeNrrd> file(fmemopen(text.data(), text.size(), "r"));
    nrrdIoStateSet(header.state.get(), nrrdIoStateSkipData, 1);
    if (nrrdRead(header.nrrd.get(), file.get(), header.state.get()) != 0) {
        char* errorMessages = biffGetDone(NRRD);
        header.problem = lastErrorMessage(errorMessages ? errorMessages : "");
        std::free(errorMessages);
    }
    return header;
}

std::optional<VoxelType> voxelTypeOf(int type)
{
    using enum VoxelType;
    static const std::map<int, VoxelType> types = {
        {nrrdTypeChar, Int8},     {nrrdTypeUChar, Uint8},   {nrrdTypeShort, Int16}, {nrrdTypeUShort, Uint16},
        {nrrdTypeInt, Int32},     {nrrdTypeUInt, Uint32},   {nrrdTypeLLong, Int64}, {nrrdTypeULLong, Uint64},
        {nrrdTypeFloat, Float32}, {nrrdTypeDouble, Float64}};
    const auto found = types.find(type);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

bool isColor(const NrrdAxisInfo& axis)
{
    const int kind = axis.kind;
    return kind == nrrdKind3Color || kind == nrrdKind4Color || kind == nrrdKindRGBColor || kind == nrrdKindRGBAColor ||
           kind == nrrdKindHSVColor || kind == nrrdKindXYZColor;
}

bool hasDirection(const NrrdAxisInfo& axis)
{
    return AIR_EXISTS(axis.spaceDirection[0]) && AIR_EXISTS(axis.spaceDirection[1]) &&
           AIR_EXISTS(axis.spaceDirection[2]);
}

/// Axes of the array; a non-spatial axis of size 1 is ignored.
struct NrrdAxes {
    std::vector<const NrrdAxisInfo*> all;
    std::vector<const NrrdAxisInfo*> ofSpace;
    bool haveDirections = false;
};

/// Finds the three spatial axes among the axes of the array; returns the problem, if any.
std::optional<core::Message> findAxes(const Nrrd& nrrd, NrrdAxes& axes)
{
    if (nrrd.dim < 3) {
        return messages::volumeNotThreeDimensional(nrrd.dim);
    }
    for (unsigned int i = 0; i < nrrd.dim; ++i) {
        axes.all.push_back(&nrrd.axis[i]);
        axes.haveDirections |= nrrd.spaceDim == 3 && hasDirection(nrrd.axis[i]);
    }
    for (const NrrdAxisInfo* axis : axes.all) {
        const bool isList = axes.haveDirections && !hasDirection(*axis);
        const bool isOther = isList || isColor(*axis) || (nrrd.dim > 3 && axis->size == 1);
        if (isOther && axis->size > 1) {
            return isColor(*axis) ? messages::volumeColors() : messages::volumeSeveralNrrd(axis->size);
        }
        if (!isOther || nrrd.dim == 3) {
            axes.ofSpace.push_back(axis);
        }
    }
    if (axes.ofSpace.size() != 3) {
        return messages::volumeDimensions(nrrd.dim);
    }
    const std::size_t first = nrrd.axis[0].size;
    const bool looksLikeColor = nrrd.dim == 3 && first > 1 && first <= 4 && nrrd.axis[0].kind == nrrdKindUnknown &&
                                nrrd.axis[1].size > 16 && nrrd.axis[2].size > 16;
    return looksLikeColor ? std::optional(messages::volumeColorAxis(first)) : std::nullopt;
}

/// Returns the signs that convert the axes of an NRRD space to LPS; nullopt for a space that is not anatomical.
std::optional<Eigen::Vector3d> lpsSignsOf(int space)
{
    switch (space) {
        case nrrdSpaceLeftPosteriorSuperior:
            return Eigen::Vector3d(1, 1, 1);
        case nrrdSpaceRightAnteriorSuperior:
            return Eigen::Vector3d(-1, -1, 1);
        case nrrdSpaceLeftAnteriorSuperior:
            return Eigen::Vector3d(1, -1, 1);
        default:
            return std::nullopt;
    }
}

std::string_view unitText(const char* unit)
{
    return unit ? unit : "";
}

/// Builds the geometry from the space directions of the file, or from plain spacings.
AxesResult placedAxes(const Nrrd& nrrd, const NrrdAxes& axes, core::Messages& warnings)
{
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    bool isSizeAssumed = false;
    Eigen::Vector3i size;
    Eigen::Vector3d unitMm = Eigen::Vector3d::Ones();   // millimeters per unit of the space, for directions and origin
    for (int k = 0; k < 3 && nrrd.spaceDim == 3; ++k) {
        unitMm[k] = millimetersPer(unitText(nrrd.spaceUnits[k]), warnings);
    }
    for (int k = 0; k < 3; ++k) {
        const NrrdAxisInfo& axis = *axes.ofSpace[static_cast<std::size_t>(k)];
        size[k] = static_cast<int>(std::min<std::size_t>(axis.size, 1U << 30U));
        if (axes.haveDirections) {
            steps.col(k) = unitMm.cwiseProduct(Eigen::Map<const Eigen::Vector3d>(axis.spaceDirection));
        } else if (AIR_EXISTS(axis.spacing)) {
            steps(k, k) = axis.spacing * millimetersPer(unitText(axis.units), warnings);
        } else {
            isSizeAssumed = true;
        }
    }
    const auto signs = lpsSignsOf(nrrd.space);
    if (!axes.haveDirections || !signs) {
        warnings.push_back(messages::volumeAxesAssumed());
    }
    if (isSizeAssumed) {
        warnings.push_back(messages::volumeSizeAssumed());
    }
    if (axes.haveDirections && steps.isIdentity(0.0)) {
        warnings.push_back(messages::volumeSizeOfOne());
    }
    const bool hasOrigin = nrrd.spaceDim == 3 && AIR_EXISTS(nrrd.spaceOrigin[0]);
    const Eigen::Vector3d origin = hasOrigin ? Eigen::Vector3d(nrrd.spaceOrigin) : Eigen::Vector3d(0, 0, 0);
    const Eigen::Vector3d turn = signs.value_or(Eigen::Vector3d::Ones());
    return geometryFromSteps(size, turn.asDiagonal() * steps, turn.cwiseProduct(unitMm).cwiseProduct(origin));
}

/// Returns the offset after the next `count` lines of a file.
core::Result<std::uint64_t> afterLines(const std::string& path, std::size_t at, int count)
{
    if (count == 0) {
        return at;
    }
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    for (; count > 0 && at < content.size(); --count) {
        at = std::min(content.find('\n', at), content.size() - 1) + 1;
    }
    return std::uint64_t{at};
}

/// Sets the location of the voxels in `source`; returns the problem, if any.
std::optional<core::Message> findSource(const NrrdIoState& state, const HeaderText& header, VoxelSource& source)
{
    if (state.encoding == nrrdEncodingBzip2) {
        return messages::volumeBzip2();
    }
    if (state.encoding != nrrdEncodingRaw && state.encoding != nrrdEncodingGzip) {
        return messages::volumeTextNrrd(state.encoding->name);
    }
    if (header.lineSkip < 0 || header.byteSkip < -1) {
        return messages::volumeSkips();
    }
    if (header.dataFile.starts_with("LIST") || header.dataFile.find('%') != std::string::npos) {
        return messages::volumeSeveralFiles();
    }
    if (header.dataFile.empty()) {
        const auto offset = afterLines(source.path, header.end, header.lineSkip);
        if (!offset) {
            return messages::volumeVoxelFileNotRead(offset.error().message);
        }
        source.offset = offset.value();
    } else if (header.lineSkip > 0) {
        return messages::volumeSkipsLinesElsewhere();
    } else {
        source.path = (std::filesystem::path(source.path).parent_path() / header.dataFile).string();
    }
    source.isCompressed = state.encoding == nrrdEncodingGzip;
    source.isBigEndian = state.endian == airEndianBig;
    source.isAtEnd = header.byteSkip == -1;
    source.skip = header.byteSkip > 0 ? static_cast<std::uint64_t>(header.byteSkip) : 0;
    return {};
}

std::string keyValue(const Nrrd& nrrd, const std::string& key)
{
    char* value = nrrdKeyValueGet(&nrrd, key.c_str());
    std::string text = value ? std::string(trimmed(value)) : std::string();
    std::free(value);
    return text;
}

/// Returns the segments that 3D Slicer declares: `Segment3_LabelValue:=4`, `Segment3_Name:=Aorta`. If segments in
/// different layers share a value, keeps the first one.
LabelNames slicerSegments(const Nrrd& nrrd)
{
    LabelNames names;
    for (int n = 0; !keyValue(nrrd, "Segment" + std::to_string(n) + "_ID").empty(); ++n) {
        const std::string segment = "Segment" + std::to_string(n);
        const auto value = parseInteger(keyValue(nrrd, segment + "_LabelValue"));
        const std::string name = keyValue(nrrd, segment + "_Name");
        if (value && !name.empty()) {
            names.emplace(*value, name.substr(0, longestSegmentName));
        }
    }
    return names;
}

}   // namespace

core::Result<StoredVolume> parseNrrd(std::string_view content, const std::string& path)
{
    const HeaderText written = splitHeader(content);
    const NrrdHeader header = parsedHeader(written.text);
    if (!header.problem.empty()) {
        return fileError(path, messages::volumeHeaderNotRead(header.problem));
    }
    const Nrrd& nrrd = *header.nrrd;
    StoredVolume stored;
    stored.path = path;
    stored.format = "NRRD";
    const auto type = voxelTypeOf(nrrd.type);
    if (!type) {
        return fileError(path, messages::volumeOtherVoxelType());
    }
    stored.type = *type;
    NrrdAxes axes;
    if (const auto problem = findAxes(nrrd, axes)) {
        return fileError(path, *problem);
    }
    const AxesResult placed = placedAxes(nrrd, axes, stored.warnings);
    if (placed.problem) {
        return fileError(path, *placed.problem);
    }
    stored.geometry = placed.geometry;
    VoxelSource source{path};
    if (const auto problem = findSource(*header.state, written, source)) {
        return fileError(path, *problem);
    }
    stored.labelNames = slicerSegments(nrrd);
    stored.isDeclaredLabelMap = path.ends_with(".seg.nrrd") || !keyValue(nrrd, "Segment0_ID").empty();
    stored.voxels = voxelStream(stored, source);
    return stored;
}

}   // namespace angiopose::io
