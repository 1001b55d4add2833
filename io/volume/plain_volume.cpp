#include "io/volume/plain_volume.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/support/text_cursor.h"
#include "io/volume/volume_axes.h"
#include "io/volume/voxel_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <type_traits>

namespace angiopose::io {
namespace {

constexpr std::size_t longestHead = 4096;
constexpr std::size_t longestMetaHeader = std::size_t{1} << 20;
constexpr std::size_t giplMagicAt = 252;
constexpr std::size_t giplHeaderBytes = 256;

std::string_view nameOf(PlainFormat format)
{
    constexpr std::string_view names[] = {"MetaImage", "VTK image", "GIPL"};
    return names[static_cast<int>(format)];
}

struct PlainHeader {
    std::optional<core::Message> problem;
    Eigen::Vector3i size = Eigen::Vector3i::Zero();
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    VoxelType type = VoxelType::Uint8;
    VoxelSource source;
    bool isText = false;   ///< whether the voxels are stored as text, separated by blanks
    core::Messages warnings;
};

PlainHeader unread(core::Message problem)
{
    PlainHeader header;
    header.problem = std::move(problem);
    return header;
}

Eigen::Vector3i sizeOf(const Eigen::Vector3d& numbers)
{
    return numbers.array().round().max(0.0).min(1 << 30).matrix().cast<int>();
}

template <class Key>
std::optional<VoxelType> typeIn(const std::map<Key, VoxelType>& types, const Key& key)
{
    const auto found = types.find(key);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// Returns the value of "key = value" in a MetaImage header, which ends with the ElementDataFile line; empty if absent.
std::string metaValue(std::string_view content, std::string_view key)
{
    std::string_view rest = content.substr(0, longestMetaHeader);
    for (bool isLast = false; !rest.empty() && !isLast;) {
        const std::size_t newline = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, newline);
        const std::size_t equals = line.find_first_of("=:");
        const std::string_view name = trimmed(line.substr(0, equals));
        if (equals != std::string_view::npos && name == key) {
            return std::string(trimmed(line.substr(equals + 1)));
        }
        isLast = name == "ElementDataFile";
        rest.remove_prefix(std::min(newline + 1, rest.size()));
    }
    return {};
}

bool isYes(const std::string& text)
{
    return !text.empty() && (text.front() == 'T' || text.front() == 't' || text.front() == '1');
}

/// Explains why the file cannot be read; returns nullopt if it can.
std::optional<core::Message> findMetaProblem(std::string_view content)
{
    const std::string object = metaValue(content, "ObjectType");
    if (!object.empty() && object != "Image") {
        return messages::volumeHoldsOther(object.substr(0, 24));
    }
    const int dimensions = parseInteger(metaValue(content, "NDims")).value_or(0);
    if (dimensions != 3) {
        return messages::volumeNotThreeDimensional(dimensions);
    }
    if (const std::string channels = metaValue(content, "ElementNumberOfChannels");
        !channels.empty() && channels != "1") {
        return messages::volumeChannels(channels.substr(0, 8));
    }
    if (const std::string binary = metaValue(content, "BinaryData"); !binary.empty() && !isYes(binary)) {
        return messages::volumeText();
    }
    const std::string dataFile = metaValue(content, "ElementDataFile");
    if (dataFile.empty()) {
        return messages::volumeNoDataFile();
    }
    if (dataFile.starts_with("LIST") || dataFile.find('%') != std::string::npos) {
        return messages::volumeSeveralFiles();
    }
    const std::string headerSize = metaValue(content, "HeaderSize");
    return !headerSize.empty() && parseInteger(headerSize).value_or(-2) < -1
               ? std::optional(messages::volumeHeaderSize())
               : std::nullopt;
}

/// Returns the location of the voxels of a MetaImage.
VoxelSource metaSource(std::string_view content, const std::string& path)
{
    VoxelSource source{path};
    const std::string dataFile = metaValue(content, "ElementDataFile");
    if (dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local") {
        source.offset = content.find('\n', content.find("ElementDataFile")) + 1;
    } else {
        source.path = (std::filesystem::path(path).parent_path() / dataFile).string();
    }
    source.isCompressed = isYes(metaValue(content, "CompressedData"));
    source.isBigEndian =
        isYes(metaValue(content, "BinaryDataByteOrderMSB")) || isYes(metaValue(content, "ElementByteOrderMSB"));
    const int skip = parseInteger(metaValue(content, "HeaderSize")).value_or(0);
    source.isAtEnd = skip == -1;
    source.skip = skip > 0 ? static_cast<std::uint64_t>(skip) : 0;
    return source;
}

/// Reads as many numbers as `numbers` can hold from the value of the first key that is present. Leaves `numbers`
/// unchanged if no key is present. Returns false if the value is not numeric.
bool readNumbers(std::string_view content, std::initializer_list<std::string_view> keys, std::span<double> numbers)
{
    for (const std::string_view key : keys) {
        const std::string value = metaValue(content, key);
        TextReader words(value);
        for (std::size_t i = 0; i < numbers.size() && !value.empty(); ++i) {
            const auto number = parseNumber(words.word());
            if (!number) {
                return false;
            }
            numbers[i] = *number;
        }
        if (!value.empty()) {
            break;
        }
    }
    return true;
}

PlainHeader metaHeader(std::string_view content, const std::string& path)
{
    using enum VoxelType;
    static const std::map<std::string, VoxelType> types = {
        {"MET_CHAR", Int8},     {"MET_UCHAR", Uint8},    {"MET_SHORT", Int16},     {"MET_USHORT", Uint16},
        {"MET_INT", Int32},     {"MET_UINT", Uint32},    {"MET_LONG", Int32},      {"MET_ULONG", Uint32},
        {"MET_FLOAT", Float32}, {"MET_DOUBLE", Float64}, {"MET_LONG_LONG", Int64}, {"MET_ULONG_LONG", Uint64}};
    if (auto problem = findMetaProblem(content)) {
        return unread(*std::move(problem));
    }
    PlainHeader header;
    Eigen::Vector3d size = Eigen::Vector3d::Zero(), spacing = Eigen::Vector3d::Ones();
    if (!readNumbers(content, {"DimSize"}, {size.data(), 3}) ||
        !readNumbers(content, {"ElementSpacing", "ElementSize"}, {spacing.data(), 3}) ||
        !readNumbers(content, {"Offset", "Position", "Origin"}, {header.origin.data(), 3}) ||
        !readNumbers(content, {"TransformMatrix", "Rotation", "Orientation"}, {header.steps.data(), 9})) {
        return unread(messages::volumeFormatHeaderNotRead(nameOf(PlainFormat::MetaImage)));
    }
    const std::string typeName = metaValue(content, "ElementType");
    const auto type = typeIn(types, typeName);
    if (!type) {
        return unread(messages::volumeVoxelType(typeName.substr(0, 24)));
    }
    const double unitMm = millimetersPer(metaValue(content, "DistanceUnits"), header.warnings);
    header.size = sizeOf(size);
    header.steps *= unitMm * spacing.asDiagonal();
    header.origin *= unitMm;
    header.type = *type;
    header.source = metaSource(content, path);
    if (metaValue(content, "ElementSpacing").empty() && metaValue(content, "ElementSize").empty()) {
        header.warnings.push_back(messages::volumeSizeAssumed());
    }
    return header;
}

/// Applies one line of a VTK image header; returns false if its value is not numeric.
bool readVtkLine(std::string_view key, TextReader& words, PlainHeader& header)
{
    if (key != "dimensions" && key != "spacing" && key != "aspect_ratio" && key != "origin") {
        return true;
    }
    const auto numbers = words.point();
    if (numbers && key == "dimensions") {
        header.size = sizeOf(*numbers);
    } else if (numbers && key == "origin") {
        header.origin = *numbers;
    } else if (numbers) {
        header.steps = numbers->asDiagonal();
    }
    return numbers.has_value();
}

PlainHeader vtkHeader(std::string_view content, const std::string& path)
{
    using enum VoxelType;
    static const std::map<std::string, VoxelType> types = {
        {"char", Int8},     {"unsigned_char", Uint8}, {"short", Int16},     {"unsigned_short", Uint16},
        {"int", Int32},     {"unsigned_int", Uint32}, {"long", Int64},      {"unsigned_long", Uint64},
        {"float", Float32}, {"double", Float64},      {"long_long", Int64}, {"unsigned_long_long", Uint64}};
    constexpr int maxLines = 64;
    const core::Message notRead = messages::volumeFormatHeaderNotRead(nameOf(PlainFormat::VtkImage));
    PlainHeader header;
    TextReader text(content);
    text.line();
    text.line();
    header.isText = toLower(text.line()) == "ascii";
    for (int line = 0; line < maxLines && !text.isAtEnd(); ++line) {
        TextReader words(text.line());
        const std::string key = toLower(words.word());
        if (!readVtkLine(key, words, header) || key == "cell_data") {
            break;
        }
        if (key != "scalars") {
            continue;
        }
        words.word();   // array name
        const auto type = typeIn(types, toLower(words.word()));
        const std::string_view components = words.word();
        if (!type || (!components.empty() && components != "1")) {
            return unread(type ? core::Message(messages::volumeChannels(std::string(components.substr(0, 8))))
                               : core::Message(messages::volumeOtherVoxelType()));
        }
        if (TextReader ahead = text; toLower(ahead.word()) == "lookup_table") {
            text.line();
        }
        header.type = *type;
        header.source = {path, content.size() - text.left()};
        header.source.isBigEndian = true;
        header.warnings.push_back(messages::volumeAxesAssumed());
        return header;
    }
    return unread(notRead);
}

/// Returns the big-endian number at an offset of a header.
template <class Number, class Bits>
Number numberAt(std::string_view content, std::size_t at)
{
    Bits bits = 0;
    for (const char byte : content.substr(at, sizeof(Bits))) {
        bits = static_cast<Bits>(bits << 8U | static_cast<unsigned char>(byte));
    }
    return std::bit_cast<Number>(bits);
}

PlainHeader giplHeader(std::string_view content, const std::string& path)
{
    using enum VoxelType;
    static const std::map<int, VoxelType> types = {{1, Uint8},   {7, Int8},   {8, Uint8},    {15, Int16},  {16, Uint16},
                                                   {31, Uint32}, {32, Int32}, {64, Float32}, {65, Float64}};
    const auto shortAt = [content](std::size_t at) { return int{numberAt<std::int16_t, std::uint16_t>(content, at)}; };
    const auto type = typeIn(types, shortAt(8));
    if (!type || shortAt(6) > 1) {
        return unread(type ? core::Message(messages::volumeNotThreeDimensional(4))
                           : core::Message(messages::volumeOtherVoxelType()));
    }
    PlainHeader header;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        header.size[axis] = shortAt(2 * k);
        header.steps(axis, axis) = static_cast<double>(numberAt<float, std::uint32_t>(content, 10 + 4 * k));
        header.origin[axis] = numberAt<double, std::uint64_t>(content, 204 + 8 * k);
    }
    header.type = *type;
    header.source = {path, giplHeaderBytes};
    header.source.isBigEndian = true;
    header.warnings.push_back(messages::volumeAxesAssumed());
    return header;
}

/// Reads voxels that are stored as text.
class TextVoxels : public VoxelReader {
public:
    TextVoxels(const StoredVolume& stored, std::uint64_t offset)
        : path_(stored.path), offset_(offset), type_(stored.type), count_(stored.geometry.voxelCount())
    {
    }

    core::Status check() const override
    {
        std::error_code failed;
        const std::uint64_t size = std::filesystem::file_size(path_, failed);
        const std::uint64_t there = size - std::min(offset_, size), least = 2 * count_ - 1;   // a digit and a blank
        return failed || there < least ? core::Status(fileError(path_, messages::volumeCutShortBy(there, least)))
                                       : core::Done{};
    }

    core::Status read(char* voxels, const ReadObserver& observe) const override
    {
        const auto input = openInput(path_);
        if (!input) {
            return input.error();
        }
        TextReader text(input.value().view().substr(std::min<std::size_t>(offset_, input.value().view().size())));
        return visitVoxelType(type_, [&](auto kind) { return readAs<decltype(kind)>(text, voxels, observe); });
    }

private:
    template <class T>
    core::Status readAs(TextReader& text, char* voxels, const ReadObserver& observe) const
    {
        for (std::size_t i = 0; i < count_; ++i) {
            if (i % 65536 == 0 && isStopRequested(observe, static_cast<double>(i) / static_cast<double>(count_))) {
                return readingCanceled(path_);
            }
            const auto number = parseNumber(text.word());
            const bool isInside = number && (!std::is_integral_v<T> ||
                                             (*number >= static_cast<double>(std::numeric_limits<T>::min()) &&
                                              *number < static_cast<double>(std::numeric_limits<T>::max()) + 1.0));
            if (!isInside) {
                return fileError(path_, messages::volumeVoxelsDamaged());
            }
            const auto value = static_cast<T>(*number);
            std::memcpy(voxels + i * sizeof(T), &value, sizeof(T));
        }
        return core::Done{};
    }

    std::string path_;
    std::uint64_t offset_;
    VoxelType type_;
    std::size_t count_;
};

}   // namespace

std::optional<PlainFormat> plainFormatOf(std::string_view content, const std::string& path)
{
    const std::string_view head = content.substr(0, longestHead);
    const std::string extension = extensionOf(path);
    if (head.starts_with("ObjectType") || head.substr(0, 544).find("ElementDataFile") != std::string_view::npos ||
        ((extension == ".mhd" || extension == ".mha") && head.find("NDims") != std::string_view::npos)) {
        return PlainFormat::MetaImage;
    }
    if (head.starts_with("# vtk DataFile") && head.find("STRUCTURED_POINTS") != std::string_view::npos) {
        return PlainFormat::VtkImage;
    }
    const std::string_view magic = head.size() >= 256 ? head.substr(giplMagicAt, 4) : std::string_view();
    const bool isGipl = magic == "\xef\xff\xe9\xb0" || magic == "\x2a\xe3\x89\xb8";
    return extension == ".gipl" && isGipl ? std::optional(PlainFormat::Gipl) : std::nullopt;
}

core::Result<StoredVolume> openPlainVolume(PlainFormat format, std::string_view content, const std::string& path)
{
    const PlainHeader header = format == PlainFormat::MetaImage  ? metaHeader(content, path)
                               : format == PlainFormat::VtkImage ? vtkHeader(content, path)
                                                                 : giplHeader(content, path);
    const AxesResult axes =
        header.problem ? AxesResult{{}, header.problem} : geometryFromSteps(header.size, header.steps, header.origin);
    if (axes.problem) {
        return fileError(path, *axes.problem);
    }
    StoredVolume stored;
    stored.path = path;
    stored.format = nameOf(format);
    stored.geometry = axes.geometry;
    stored.type = header.type;
    stored.warnings = header.warnings;
    stored.voxels =
        header.isText ? std::make_shared<TextVoxels>(stored, header.source.offset) : voxelStream(stored, header.source);
    return stored;
}

}   // namespace angiopose::io
