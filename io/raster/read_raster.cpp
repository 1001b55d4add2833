#include "io/raster/read_raster.h"

#include "io/messages/says.h"
#include "io/raster/raster_integrity.h"
#include "io/raster/read_jpeg.h"
#include "io/raster/read_tiff.h"
#include "io/support/captured_stderr.h"
#include "io/support/file_error.h"
#include "io/support/quiet_libraries.h"

#include <itkPNGImageIO.h>
#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t maxBytes = std::size_t{800} << 20;   // decoded samples and their float copy together
constexpr unsigned int maxSide = 32'768;
constexpr unsigned int minSide = 8;

struct RasterShape {
    int width = 0, height = 0, frames = 1, channels = 1;
};

std::optional<RasterShape> shapeOf(const itk::ImageIOBase& reader)
{
    const auto width = reader.GetDimensions(0), height = reader.GetDimensions(1);
    const auto frames = reader.GetNumberOfDimensions() > 2 ? reader.GetDimensions(2) : 1;
    if (width < minSide || height < minSide || frames == 0 || width > maxSide || height > maxSide ||
        reader.GetNumberOfComponents() > 4) {
        return std::nullopt;
    }
    const std::size_t bytesPerPixel =
        sizeof(float) + std::size_t{reader.GetComponentSize()} * reader.GetNumberOfComponents();
    if (width * height > maxBytes / bytesPerPixel / frames) {
        return std::nullopt;
    }
    return RasterShape{static_cast<int>(width), static_cast<int>(height), static_cast<int>(frames),
                       static_cast<int>(reader.GetNumberOfComponents())};
}

template <class Sample>
Raster greyFrom(const std::vector<char>& bytes, const RasterShape& shape)
{
    const auto* samples = reinterpret_cast<const Sample*>(bytes.data());
    const auto channels = static_cast<std::size_t>(shape.channels);
    Raster raster;
    raster.hadAlpha = shape.channels == 2 || shape.channels == 4;
    for (int k = 0; k < shape.frames; ++k) {
        core::ImageF frame(shape.width, shape.height);
        for (float& value : frame.pixels) {
            if (shape.channels < 3) {
                value = static_cast<float>(samples[0]);
            } else {   // luminance, Rec. 601; exact where the channels agree
                const bool isGrey = samples[0] == samples[1] && samples[1] == samples[2];
                value = isGrey ? static_cast<float>(samples[0])
                               : static_cast<float>(0.299 * static_cast<double>(samples[0]) +
                                                    0.587 * static_cast<double>(samples[1]) +
                                                    0.114 * static_cast<double>(samples[2]));
                raster.wasColour |= !isGrey;
            }
            samples += channels;
        }
        raster.frames.push_back(std::move(frame));
    }
    return raster;
}

std::optional<Raster> convert(itk::IOComponentEnum type, const std::vector<char>& bytes, const RasterShape& shape)
{
    switch (type) {
        case itk::IOComponentEnum::UCHAR:
            return greyFrom<unsigned char>(bytes, shape);
        case itk::IOComponentEnum::CHAR:
            return greyFrom<signed char>(bytes, shape);
        case itk::IOComponentEnum::USHORT:
            return greyFrom<unsigned short>(bytes, shape);
        case itk::IOComponentEnum::SHORT:
            return greyFrom<short>(bytes, shape);
        case itk::IOComponentEnum::UINT:
            return greyFrom<unsigned int>(bytes, shape);
        case itk::IOComponentEnum::INT:
            return greyFrom<int>(bytes, shape);
        case itk::IOComponentEnum::FLOAT:
            return greyFrom<float>(bytes, shape);
        default:
            return std::nullopt;
    }
}

bool isFinite(const Raster& raster)
{
    return std::all_of(raster.frames.begin(), raster.frames.end(), [](const core::ImageF& frame) {
        return std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); });
    });
}

std::vector<char> readBytes(itk::ImageIOBase& reader)
{
    std::vector<char> bytes(static_cast<std::size_t>(reader.GetImageSizeInBytes()));
    itk::ImageIORegion region(reader.GetNumberOfDimensions());
    for (unsigned int axis = 0; axis < reader.GetNumberOfDimensions(); ++axis) {
        region.SetSize(axis, reader.GetDimensions(axis));
    }
    reader.SetIORegion(region);
    reader.Read(bytes.data());
    return bytes;
}

}   // namespace

bool looksLikeRaster(std::string_view content)
{
    return content.starts_with("\x89PNG") || content.starts_with("\xff\xd8\xff") ||
           content.starts_with(std::string_view("II*\0", 4)) || content.starts_with(std::string_view("MM\0*", 4));
}

core::Result<Raster> readRaster(std::string_view content, const std::string& path)
{
    quietLibraries();
    if (const auto damage = findRasterDamage(content)) {
        return fileError(path, *damage);
    }
    if (!content.starts_with("\x89PNG")) {
        auto raster = content.starts_with("\xff\xd8") ? readJpeg(content) : readTiff(path);
        return raster && isFinite(*raster) ? core::Result<Raster>(std::move(*raster))
                                           : fileError(path, says::imageUnusual());
    }
    try {
        const CapturedStderr unheard;   // libpng's warnings about what is not the picture
        const itk::ImageIOBase::Pointer reader = itk::PNGImageIO::New().GetPointer();
        reader->SetFileName(path);
        reader->ReadImageInformation();
        const auto shape = shapeOf(*reader);
        if (!shape) {
            return fileError(path, says::imageSize());
        }
        const std::vector<char> bytes = readBytes(*reader);
        auto raster = convert(reader->GetComponentType(), bytes, *shape);
        if (!raster || !isFinite(*raster)) {
            return fileError(path, says::imagePixelKind());
        }
        return std::move(*raster);
    } catch (const std::exception&) {   // itk::ExceptionObject, std::bad_alloc
        return fileError(path, says::imageUndecodable());
    }
}

}   // namespace angiopose::io