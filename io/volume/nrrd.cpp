#include "io/volume/nrrd.h"

#include "io/messages/says.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/volume/nrrd_fields.h"
#include "io/volume/volume_axes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace angiopose::io {
namespace {

/// Signs that turn the space's axes into LPS; nothing for spaces that are not of the patient.
std::optional<Eigen::Vector3d> lpsSignsOf(const std::string& space)
{
    if (space == "lps" || space == "left-posterior-superior") {
        return Eigen::Vector3d(1, 1, 1);
    }
    if (space == "ras" || space == "right-anterior-superior") {
        return Eigen::Vector3d(-1, -1, 1);
    }
    if (space == "las" || space == "left-anterior-superior") {
        return Eigen::Vector3d(1, -1, 1);
    }
    return std::nullopt;
}

double millimetresPer(const std::string& unit)
{
    static const std::map<std::string, double> lengths = {{"m", 1000.0},        {"meters", 1000.0}, {"cm", 10.0},
                                                          {"\xc2\xb5m", 1e-3},  {"um", 1e-3},       {"microns", 1e-3},
                                                          {"micrometers", 1e-3}};
    const auto found = lengths.find(unit);
    return found == lengths.end() ? 1.0 : found->second;
}

/// The three axes of space among those of the array; a fourth of one element is left out.
std::optional<core::Message> findSizes(const NrrdFields& fields, Eigen::Vector3i& size, std::vector<std::size_t>& axes)
{
    const std::vector<std::string> sizes = wordsOf(field(fields, "sizes"));
    const std::vector<std::string> kinds = wordsOf(lowered(field(fields, "kinds")));
    const auto directions = vectorsOf(field(fields, "space directions"));
    if (sizes.size() < 3) {
        return says::volumeNotThreeDimensional(sizes.size());
    }
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto count = parseInteger(sizes[i]);
        if (!count || *count < 1) {
            return says::volumeSizesNoNumbers();
        }
        const bool isList = directions && i < directions->size() && !(*directions)[i];
        const bool isColour = i < kinds.size() && kinds[i].find("color") != std::string::npos;
        const bool isOther = isList || isColour || (sizes.size() > 3 && *count == 1);
        if (isOther && *count > 1) {
            return isColour ? says::volumeColours() : says::volumeSeveralNrrd(*count);
        }
        if (!isOther || sizes.size() == 3) {
            axes.push_back(i);
        }
    }
    if (axes.size() != 3) {
        return says::volumeDimensions(sizes.size());
    }
    for (std::size_t k = 0; k < 3; ++k) {
        size[static_cast<int>(k)] = *parseInteger(sizes[axes[k]]);
    }
    const bool looksLikeColour = sizes.size() == 3 && size[0] <= 4 && kinds.empty() && size[1] > 16 && size[2] > 16;
    return looksLikeColour && size[0] > 1 ? std::optional(says::volumeColourAxis(size[0])) : std::nullopt;
}

/// Steps as the file's space gives them, or as plain spacings.
Eigen::Matrix3d stepsOf(const NrrdFields& fields, const std::vector<std::size_t>& axes, core::Messages& warnings)
{
    const std::string space = lowered(field(fields, "space"));
    const auto signs = lpsSignsOf(space);
    const auto directions = vectorsOf(field(fields, "space directions"));
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    bool hasDirections = directions && directions->size() > axes.back();
    for (std::size_t k = 0; k < 3 && hasDirections; ++k) {
        const auto& direction = (*directions)[axes[k]];
        hasDirections = direction.has_value();
        steps.col(static_cast<int>(k)) = direction.value_or(Eigen::Vector3d::Zero());
    }
    if (hasDirections) {
        const std::vector<std::string> units = wordsOf(lowered(field(fields, "space units")));
        if (!units.empty()) {
            std::string unit = units.front();
            std::erase(unit, '"');
            steps *= millimetresPer(unit);
        }
    } else {
        const std::vector<std::string> spacings = wordsOf(field(fields, "spacings"));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto number = axes[k] < spacings.size() ? parseNumber(spacings[axes[k]]) : std::nullopt;
            steps.col(static_cast<int>(k)) = Eigen::Vector3d::Unit(static_cast<int>(k)) * number.value_or(1.0);
        }
    }
    if (!hasDirections || !signs) {
        warnings.push_back(says::volumeAxesAssumed());
    }
    if (hasDirections && steps.isIdentity(0.0)) {
        warnings.push_back(says::volumeSizeOfOne());
    }
    return signs ? Eigen::Matrix3d(signs->asDiagonal() * steps) : steps;
}

Eigen::Vector3d originOf(const NrrdFields& fields)
{
    const auto origin = vectorsOf(field(fields, "space origin"));
    const auto signs = lpsSignsOf(lowered(field(fields, "space"))).value_or(Eigen::Vector3d::Ones());
    return origin && origin->size() == 1 && origin->front() ? Eigen::Vector3d(signs.cwiseProduct(*origin->front()))
                                                            : Eigen::Vector3d::Zero();
}

/// Where the next `count` lines of a file end.
std::optional<std::size_t> afterLines(std::string_view content, std::size_t at, int count)
{
    for (; count > 0; --count) {
        const std::size_t newline = content.find('\n', at);
        if (newline == std::string_view::npos) {
            return std::nullopt;
        }
        at = newline + 1;
    }
    return at;
}

std::optional<core::Message> findEncodingProblem(const std::string& encoding)
{
    if (encoding == "raw" || encoding == "gzip" || encoding == "gz") {
        return {};
    }
    if (encoding == "bzip2" || encoding == "bz2") {
        return says::volumeBzip2();
    }
    return says::volumeTextNrrd(encoding.substr(0, 16));
}

/// Fills in where the voxels lie; returns what is wrong.
std::optional<core::Message> findSource(const NrrdFields& fields, std::string_view content, std::size_t dataStart,
                                        VoxelSource& source)
{
    const std::string encoding = lowered(field(fields, "encoding"));
    if (const auto problem = findEncodingProblem(encoding)) {
        return problem;
    }
    source.packing = encoding == "raw" ? StreamPacking::None : StreamPacking::Deflate;
    const int lines = parseInteger(field(fields, "line skip").empty() ? "0" : field(fields, "line skip")).value_or(-1);
    const int bytes = parseInteger(field(fields, "byte skip").empty() ? "0" : field(fields, "byte skip")).value_or(-2);
    if (lines < 0 || bytes < -1) {
        return says::volumeSkips();
    }
    const std::string dataFile = field(fields, fields.contains("data file") ? "data file" : "datafile");
    if (dataFile.starts_with("LIST") || dataFile.find('%') != std::string::npos) {
        return says::volumeSeveralFiles();
    }
    if (!dataFile.empty()) {
        source.path = (std::filesystem::path(source.path).parent_path() / dataFile).string();
        source.offset = 0;
        if (lines > 0) {
            return says::volumeSkipsLinesElsewhere();
        }
    } else {
        const auto start = afterLines(content, dataStart, lines);
        if (!start) {
            return says::volumeCutShort();
        }
        source.offset = *start;
    }
    source.isAtEnd = bytes == -1;
    source.skip = bytes > 0 ? static_cast<std::uint64_t>(bytes) : 0;
    return {};
}

}   // namespace

core::Result<StoredVolume> parseNrrd(std::string_view content, const std::string& path)
{
    std::size_t dataStart = 0;
    const NrrdFields fields = nrrdFieldsOf(content, dataStart);
    StoredVolume stored;
    stored.path = path;
    stored.format = "NRRD";
    const auto type = nrrdTypeOf(lowered(field(fields, "type")));
    if (!type) {
        return fileError(path, says::volumeVoxelType(field(fields, "type").substr(0, 24)));
    }
    stored.type = *type;
    stored.isBigEndian = lowered(field(fields, "endian")) == "big";
    Eigen::Vector3i size;
    std::vector<std::size_t> axes;
    if (const auto problem = findSizes(fields, size, axes)) {
        return fileError(path, *problem);
    }
    const AxesResult placed = geometryFromSteps(size, stepsOf(fields, axes, stored.warnings), originOf(fields));
    if (placed.problem) {
        return fileError(path, *placed.problem);
    }
    stored.geometry = placed.geometry;
    stored.source.path = path;
    if (const auto problem = findSource(fields, content, dataStart, stored.source)) {
        return fileError(path, *problem);
    }
    stored.isDeclaredLabels = path.ends_with(".seg.nrrd") || fields.contains("segment0_id");
    return stored;
}

}   // namespace angiopose::io