#include "io/volume/meta_image.h"

#include "io/messages/says.h"
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

std::optional<core::Message> findUnsupported(const Fields& fields)
{
    const std::string object = field(fields, {"ObjectType"});
    if (!object.empty() && object != "Image") {
        return says::volumeHoldsOther(object.substr(0, 24));
    }
    const int dimensions = parseInteger(field(fields, {"NDims"})).value_or(0);
    if (dimensions != 3) {
        return says::volumeNotThreeDimensional(dimensions);
    }
    if (const std::string channels = field(fields, {"ElementNumberOfChannels"}); !channels.empty() && channels != "1") {
        return says::volumeChannels(channels.substr(0, 8));
    }
    const std::string type = field(fields, {"ElementType"});
    if (!typeOf(type)) {
        return says::volumeVoxelType(type.substr(0, 24));
    }
    const std::string binary = field(fields, {"BinaryData"});
    return !binary.empty() && !isTrue(binary) ? std::optional(says::volumeText()) : std::nullopt;
}

AxesResult axesOf(const Fields& fields, core::Messages& warnings)
{
    const auto sizes = numbersOf(field(fields, {"DimSize"}), 3);
    if (!sizes || *std::max_element(sizes->begin(), sizes->end()) > 1e9) {
        return {{}, says::volumeDimSize()};
    }
    const auto spacing = numbersOf(field(fields, {"ElementSpacing", "ElementSize"}), 3);
    const auto matrix = numbersOf(field(fields, {"TransformMatrix", "Rotation", "Orientation"}), 9);
    const auto offset = numbersOf(field(fields, {"Offset", "Position", "Origin"}), 3);
    if (!spacing) {
        warnings.push_back(says::volumeSizeAssumed());
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

std::optional<core::Message> findSource(const Fields& fields, std::size_t dataStart, VoxelSource& source)
{
    const std::string dataFile = field(fields, {"ElementDataFile"});
    if (dataFile.empty()) {
        return says::volumeNoDataFile();
    }
    if (dataFile.starts_with("LIST") || dataFile.find('%') != std::string::npos) {
        return says::volumeSeveralFiles();
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
        return says::volumeHeaderSize();
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
    if (const auto problem = findUnsupported(fields)) {
        return fileError(path, *problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = "MetaImage";
    stored.type = *typeOf(field(fields, {"ElementType"}));
    stored.isBigEndian = isTrue(field(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));
    const AxesResult axes = axesOf(fields, stored.warnings);
    if (axes.problem) {
        return fileError(path, *axes.problem);
    }
    stored.geometry = axes.geometry;
    stored.source.path = path;
    if (const auto problem = findSource(fields, dataStart, stored.source)) {
        return fileError(path, *problem);
    }
    return stored;
}

}   // namespace angiopose::io