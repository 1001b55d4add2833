#include "io/volume/meta_image.h"

#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/volume/volume_axes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

namespace angiopose::io {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

/// "Key = value" lines up to ElementDataFile, which is the last one; `end` is where local data begin.
Fields fieldsOf(std::string_view content, std::size_t& end)
{
    Fields fields;
    std::size_t at = 0;
    while (at < content.size() && !fields.contains("ElementDataFile")) {
        const std::size_t newline = std::min(content.find('\n', at), content.size());
        const std::string_view line = content.substr(at, newline - at);
        at = std::min(newline + 1, content.size());
        if (const std::size_t equals = line.find('='); equals != std::string_view::npos) {
            fields.emplace(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
        }
    }
    end = at;
    return fields;
}

std::string field(const Fields& fields, std::initializer_list<const char*> names)
{
    for (const char* name : names) {
        if (const auto found = fields.find(name); found != fields.end()) {
            return found->second;
        }
    }
    return {};
}

bool isTrue(const std::string& text)
{
    return text == "True" || text == "true" || text == "TRUE" || text == "1" || text == "T";
}

/// Exactly `count` numbers, or nothing.
std::optional<std::vector<double>> numbersOf(const std::string& text, std::size_t count)
{
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string word; stream >> word;) {
        const auto number = parseNumber(word);
        if (!number || numbers.size() == count) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

std::optional<VoxelType> typeOf(const std::string& name)
{
    static const std::map<std::string, VoxelType> types = {
        {"MET_CHAR", VoxelType::Int8},       {"MET_UCHAR", VoxelType::Uint8},       {"MET_SHORT", VoxelType::Int16},
        {"MET_USHORT", VoxelType::Uint16},   {"MET_INT", VoxelType::Int32},         {"MET_UINT", VoxelType::Uint32},
        {"MET_LONG_LONG", VoxelType::Int64}, {"MET_ULONG_LONG", VoxelType::Uint64}, {"MET_FLOAT", VoxelType::Float32},
        {"MET_DOUBLE", VoxelType::Float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

std::string findUnsupported(const Fields& fields)
{
    const std::string object = field(fields, {"ObjectType"});
    if (!object.empty() && object != "Image") {
        return "it holds a " + object.substr(0, 24) + ", not an image. Choose the scan.";
    }
    const int dimensions = parseInteger(field(fields, {"NDims"})).value_or(0);
    if (dimensions != 3) {
        return "it is " + std::to_string(dimensions) +
               "-dimensional, but a volume has three dimensions. Choose the whole scan.";
    }
    if (const std::string channels = field(fields, {"ElementNumberOfChannels"}); !channels.empty() && channels != "1") {
        return "it has " + channels.substr(0, 8) + " values per voxel. Choose the scan itself, in grey values.";
    }
    const std::string type = field(fields, {"ElementType"});
    if (!typeOf(type)) {
        return "its voxel type (\"" + type.substr(0, 24) + "\") is not read. Save it as 16-bit or float.";
    }
    const std::string binary = field(fields, {"BinaryData"});
    return !binary.empty() && !isTrue(binary) ? "its voxels are written as text. Save it with binary data."
                                              : std::string();
}

AxesResult axesOf(const Fields& fields, std::vector<std::string>& warnings)
{
    const auto sizes = numbersOf(field(fields, {"DimSize"}), 3);
    if (!sizes || *std::max_element(sizes->begin(), sizes->end()) > 1e9) {
        return {{}, "its DimSize makes no sense. The file is damaged; export it again."};
    }
    const auto spacing = numbersOf(field(fields, {"ElementSpacing", "ElementSize"}), 3);
    const auto matrix = numbersOf(field(fields, {"TransformMatrix", "Rotation", "Orientation"}), 9);
    const auto offset = numbersOf(field(fields, {"Offset", "Position", "Origin"}), 3);
    if (!spacing) {
        warnings.emplace_back("The header gives no voxel size: 1 x 1 x 1 mm is assumed.");
    }
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    for (int axis = 0; axis < 3; ++axis) {
        if (matrix) {   // one row of the file per axis of the array
            steps.col(axis) = Eigen::Map<const Eigen::Vector3d>(matrix->data() + std::ptrdiff_t{3} * axis);
        }
        steps.col(axis) *= spacing ? (*spacing)[static_cast<std::size_t>(axis)] : 1.0;
    }
    const Eigen::Vector3d origin =
        offset ? Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(offset->data())) : Eigen::Vector3d::Zero();
    const Eigen::Vector3i size(static_cast<int>((*sizes)[0]), static_cast<int>((*sizes)[1]),
                               static_cast<int>((*sizes)[2]));
    return geometryFromSteps(size, steps, origin);
}

std::string findSource(const Fields& fields, std::size_t dataStart, VoxelSource& source)
{
    const std::string dataFile = field(fields, {"ElementDataFile"});
    if (dataFile.empty()) {
        return "it does not say where its voxels are (ElementDataFile). Export it again.";
    }
    if (dataFile.starts_with("LIST") || dataFile.find('%') != std::string::npos) {
        return "its voxels lie in several files. Save it as one file.";
    }
    const bool isLocal = dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local";
    source.offset = isLocal ? dataStart : 0;
    if (!isLocal) {
        source.path = (std::filesystem::path(source.path).parent_path() / dataFile).string();
    }
    const bool isPacked = isTrue(field(fields, {"CompressedData"}));
    source.packing = isPacked ? StreamPacking::Deflate : StreamPacking::None;
    const std::string headerSize = field(fields, {"HeaderSize"});
    const int bytes = headerSize.empty() ? 0 : parseInteger(headerSize).value_or(-2);
    if (bytes < -1) {
        return "its HeaderSize makes no sense. Correct the header.";
    }
    source.isAtEnd = bytes == -1;
    source.skip = bytes > 0 ? static_cast<std::uint64_t>(bytes) : 0;
    return {};
}

}   // namespace

core::Result<StoredVolume> parseMetaImage(std::string_view content, const std::string& path)
{
    std::size_t dataStart = 0;
    const Fields fields = fieldsOf(content, dataStart);
    if (const std::string problem = findUnsupported(fields); !problem.empty()) {
        return fileError(path, problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = "MetaImage";
    stored.type = *typeOf(field(fields, {"ElementType"}));
    stored.isBigEndian = isTrue(field(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));
    const AxesResult axes = axesOf(fields, stored.warnings);
    if (!axes.problem.empty()) {
        return fileError(path, axes.problem);
    }
    stored.geometry = axes.geometry;
    stored.source.path = path;
    if (const std::string problem = findSource(fields, dataStart, stored.source); !problem.empty()) {
        return fileError(path, problem);
    }
    return stored;
}

}   // namespace angiopose::io