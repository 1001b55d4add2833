#include "io/volume/itk_volume.h"

#include "io/messages/says.h"
#include "io/messages/says_readers.h"
#include "io/support/decimal_point.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"
#include "io/support/quiet_libraries.h"
#include "io/volume/volume_axes.h"
#include "io/volume/voxel_stream.h"

#include <itkGiplImageIO.h>
#include <itkMetaImageIO.h>
#include <itkVTKImageIO.h>
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace angiopose::io {
namespace {

constexpr std::size_t longestHead = 4096;
constexpr std::size_t longestMetaHeader = std::size_t{1} << 20;
constexpr std::size_t giplMagicAt = 252;
constexpr std::size_t giplHeader = 256;
constexpr std::size_t slabBytes = std::size_t{4} << 20;

std::string_view nameOf(ItkFormat format)
{
    constexpr std::string_view names[] = {"MetaImage", "VTK image", "GIPL"};
    return names[static_cast<int>(format)];
}

/// The value of "key = value" in the header of a MetaImage, which ends with the line of ElementDataFile; empty when
/// absent.
std::string metaValue(std::string_view content, std::string_view key)
{
    std::string_view rest = content.substr(0, longestMetaHeader);
    for (bool isLast = false; !rest.empty() && !isLast;) {
        const std::size_t newline = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, newline);
        const std::size_t equals = line.find('=');
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

/// A line of a MetaImage's header that ends the program in MetaIO (ITK 5.2): a name, or the value of one of three keys,
/// for which it has no room; or no "key = value", after which it takes the next line for the value and, where that was
/// the last one, voxels for lines.
std::optional<core::Message> findBadLine(std::string_view content)
{
    constexpr std::size_t longest = 254;
    constexpr std::array<std::string_view, 3> heldKeys{"Comment", "Name", "ObjectSubType"};
    std::string_view rest = content.substr(0, longestMetaHeader);
    std::string_view name;
    for (int line = 1; !rest.empty() && name != "ElementDataFile"; ++line) {
        const std::string_view text = rest.substr(0, rest.find_first_of("\r\n"));
        const std::size_t sign = std::min(text.find_first_of("=:"), text.size());
        name = trimmed(text.substr(0, sign));
        const bool isHeld = std::ranges::find(heldKeys, name) != heldKeys.end();
        if (name.size() > longest || (isHeld && text.size() - sign > longest)) {
            return says::readerLineTooLong(line, static_cast<int>(longest));
        }
        if (sign == text.size() && !name.empty()) {
            return says::readerLineWithoutSign(line);
        }
        const bool isDosEnd = rest.substr(text.size()).starts_with("\r\n");
        rest.remove_prefix(std::min(text.size() + (isDosEnd ? 2 : 1), rest.size()));
    }
    return {};
}

/// What ITK would pass over or refuse without saying why.
std::optional<core::Message> findMetaProblem(std::string_view content)
{
    if (const auto bad = findBadLine(content)) {
        return bad;
    }
    const std::string object = metaValue(content, "ObjectType");
    if (!object.empty() && object != "Image") {
        return says::volumeHoldsOther(object.substr(0, 24));
    }
    const int dimensions = parseInteger(metaValue(content, "NDims")).value_or(0);
    if (dimensions != 3) {
        return says::volumeNotThreeDimensional(dimensions);
    }
    if (const std::string channels = metaValue(content, "ElementNumberOfChannels");
        !channels.empty() && channels != "1") {
        return says::volumeChannels(channels.substr(0, 8));
    }
    if (const std::string binary = metaValue(content, "BinaryData"); !binary.empty() && !isYes(binary)) {
        return says::volumeText();
    }
    const std::string dataFile = metaValue(content, "ElementDataFile");
    if (dataFile.empty()) {
        return says::volumeNoDataFile();
    }
    if (dataFile.starts_with("LIST") || dataFile.find('%') != std::string::npos) {
        return says::volumeSeveralFiles();
    }
    const std::string headerSize = metaValue(content, "HeaderSize");
    return !headerSize.empty() && parseInteger(headerSize).value_or(-2) < -1 ? std::optional(says::volumeHeaderSize())
                                                                             : std::nullopt;
}

/// Where the voxels of a MetaImage lie.
VoxelSource metaSource(std::string_view content, const std::string& path)
{
    VoxelSource source{path};
    const std::string dataFile = metaValue(content, "ElementDataFile");
    if (dataFile == "LOCAL" || dataFile == "Local" || dataFile == "local") {
        source.offset = content.find('\n', content.find("ElementDataFile")) + 1;
    } else {
        source.path = (std::filesystem::path(path).parent_path() / dataFile).string();
    }
    source.isPacked = isYes(metaValue(content, "CompressedData"));
    source.isBigEndian =
        isYes(metaValue(content, "BinaryDataByteOrderMSB")) || isYes(metaValue(content, "ElementByteOrderMSB"));
    const int skip = parseInteger(metaValue(content, "HeaderSize")).value_or(0);
    source.isAtEnd = skip == -1;
    source.skip = skip > 0 ? static_cast<std::uint64_t>(skip) : 0;
    return source;
}

itk::ImageIOBase::Pointer makeReader(ItkFormat format)
{
    switch (format) {
        case ItkFormat::MetaImage:
            return itk::MetaImageIO::New().GetPointer();
        case ItkFormat::VtkImage:
            return itk::VTKImageIO::New().GetPointer();
        default:
            return itk::GiplImageIO::New().GetPointer();
    }
}

std::optional<VoxelType> voxelTypeOf(itk::IOComponentEnum type)
{
    using enum itk::CommonEnums::IOComponent;
    static const std::map<itk::IOComponentEnum, VoxelType> types = {
        {CHAR, VoxelType::Int8},        {UCHAR, VoxelType::Uint8},   {SHORT, VoxelType::Int16},
        {USHORT, VoxelType::Uint16},    {INT, VoxelType::Int32},     {UINT, VoxelType::Uint32},
        {LONG, VoxelType::Int64},       {ULONG, VoxelType::Uint64},  {LONGLONG, VoxelType::Int64},
        {ULONGLONG, VoxelType::Uint64}, {FLOAT, VoxelType::Float32}, {DOUBLE, VoxelType::Float64}};
    const auto found = types.find(type);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

/// Voxels by ITK: slab by slab where the format lets it, else in one go.
class ItkVoxels : public VoxelReader {
public:
    ItkVoxels(itk::ImageIOBase::Pointer reader, std::string path, std::uint64_t headerBytes)
        : reader_(std::move(reader)), path_(std::move(path)), headerBytes_(headerBytes)
    {
    }

    core::Status check() const override;
    core::Status read(char* voxels, const ReadObserver& observe) const override;

private:
    itk::ImageIOBase::Pointer reader_;
    std::string path_;
    std::uint64_t headerBytes_;
};

core::Status ItkVoxels::check() const
{
    std::error_code failed;
    const std::uint64_t needed = reader_->GetImageSizeInBytes();
    const std::uint64_t there = std::filesystem::file_size(path_, failed);
    const bool isText = reader_->GetFileType() == itk::IOFileEnum::ASCII;   // a digit and a blank for every voxel
    // GIPL does not look whether its voxels are there; its header takes 256 bytes.
    const std::uint64_t least = isText ? 2 * needed / reader_->GetComponentSize() - 1 : needed + headerBytes_;
    return failed || there < least ? core::Status(fileError(path_, says::volumeCutShortBy(there, least)))
                                   : core::Done{};
}

core::Status ItkVoxels::read(char* voxels, const ReadObserver& observe) const
{
    const DecimalPoint decimalPoint;   // VTK images of text
    const std::size_t layers = reader_->GetDimensions(2);
    const std::size_t layerBytes = static_cast<std::size_t>(reader_->GetImageSizeInBytes()) / layers;
    const std::size_t step = reader_->CanStreamRead() ? std::max<std::size_t>(1, slabBytes / layerBytes) : layers;
    itk::ImageIORegion region(3);
    region.SetSize(0, reader_->GetDimensions(0));
    region.SetSize(1, reader_->GetDimensions(1));
    for (std::size_t first = 0; first < layers; first += step) {
        if (isStopWished(observe, static_cast<double>(first) / static_cast<double>(layers))) {
            return stoppedReading(path_);
        }
        region.SetIndex(2, static_cast<itk::ImageIORegion::IndexValueType>(first));
        region.SetSize(2, std::min(step, layers - first));
        reader_->SetIORegion(region);
        try {
            reader_->Read(voxels + first * layerBytes);
        } catch (const std::exception&) {
            return fileError(path_, says::volumeVoxelsDamaged());
        }
    }
    return core::Done{};
}

/// The reader with its header read; nothing when ITK cannot.
itk::ImageIOBase::Pointer openedReader(ItkFormat format, const std::string& path)
{
    quietLibraries();
    const DecimalPoint decimalPoint;
    itk::ImageIOBase::Pointer reader = makeReader(format);
    try {
        reader->SetFileName(path);
        reader->ReadImageInformation();
        return reader;
    } catch (const std::exception&) {   // itk::ExceptionObject, std::bad_alloc
        return nullptr;
    }
}

AxesResult placeOf(const itk::ImageIOBase& reader, double unitMm)
{
    Eigen::Vector3i size;
    Eigen::Matrix3d steps;
    Eigen::Vector3d origin;
    for (unsigned int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<Eigen::Index>(axis);
        size[at] = static_cast<int>(std::min<std::size_t>(reader.GetDimensions(axis), 1U << 30U));
        origin[at] = reader.GetOrigin(axis);
        const std::vector<double> direction = reader.GetDirection(axis);
        steps.col(at) = Eigen::Map<const Eigen::Vector3d>(direction.data()) * reader.GetSpacing(axis);
    }
    return geometryFromSteps(size, unitMm * steps, unitMm * origin);
}

std::optional<core::Message> findShapeProblem(const itk::ImageIOBase& reader)
{
    if (reader.GetNumberOfDimensions() != 3) {
        return says::volumeNotThreeDimensional(reader.GetNumberOfDimensions());
    }
    return reader.GetNumberOfComponents() != 1 ? std::optional(says::volumeChannels(reader.GetNumberOfComponents()))
                                               : std::nullopt;
}

}   // namespace

std::optional<ItkFormat> itkFormatOf(std::string_view content, const std::string& path)
{
    const std::string_view head = content.substr(0, longestHead);
    const std::string extension = extensionOf(path);
    if (head.starts_with("ObjectType") || head.substr(0, 544).find("ElementDataFile") != std::string_view::npos ||
        ((extension == ".mhd" || extension == ".mha") && head.find("NDims") != std::string_view::npos)) {
        return ItkFormat::MetaImage;
    }
    if (head.starts_with("# vtk DataFile") && head.find("STRUCTURED_POINTS") != std::string_view::npos) {
        return ItkFormat::VtkImage;
    }
    const std::string_view magic = head.size() >= 256 ? head.substr(giplMagicAt, 4) : std::string_view();
    const bool isGipl = magic == "\xef\xff\xe9\xb0" || magic == "\x2a\xe3\x89\xb8";
    return extension == ".gipl" && isGipl ? std::optional(ItkFormat::Gipl) : std::nullopt;
}

core::Result<StoredVolume> openItkVolume(ItkFormat format, std::string_view content, const std::string& path)
{
    const bool isMeta = format == ItkFormat::MetaImage;
    if (const auto problem = isMeta ? findMetaProblem(content) : std::nullopt) {
        return fileError(path, *problem);
    }
    const itk::ImageIOBase::Pointer reader = openedReader(format, path);
    if (!reader) {
        return fileError(path, says::volumeFormatHeaderNotRead(nameOf(format)));
    }
    if (const auto problem = findShapeProblem(*reader)) {
        return fileError(path, *problem);
    }
    const auto type = voxelTypeOf(reader->GetComponentType());
    if (!type) {
        return fileError(path, isMeta ? says::volumeVoxelType(metaValue(content, "ElementType").substr(0, 24))
                                      : says::volumeOtherVoxelType());
    }
    StoredVolume stored;
    const AxesResult axes =
        placeOf(*reader, millimetresPer(isMeta ? metaValue(content, "DistanceUnits") : "", stored.warnings));
    if (axes.problem) {
        return fileError(path, *axes.problem);
    }
    stored.path = path;
    stored.format = nameOf(format);
    stored.geometry = axes.geometry;
    stored.type = *type;
    if (isMeta && metaValue(content, "ElementSpacing").empty() && metaValue(content, "ElementSize").empty()) {
        stored.warnings.push_back(says::volumeSizeAssumed());
    }
    if (!isMeta) {
        stored.warnings.push_back(says::volumeAxesAssumed());
    }
    // ITK takes packed voxels that are damaged or cut short for whole ones: MetaImage gives its header only.
    stored.voxels = isMeta ? voxelStream(stored, metaSource(content, path))
                           : std::shared_ptr<const VoxelReader>(
                                 std::make_shared<ItkVoxels>(reader, path, format == ItkFormat::Gipl ? giplHeader : 0));
    return stored;
}

}   // namespace angiopose::io
