#include "io/raster/read_raster.h"

#include "io/messages/messages.h"
#include "io/raster/image_orientation.h"
#include "io/raster/read_jpeg.h"
#include "io/raster/read_png.h"
#include "io/raster/read_tiff.h"
#include "io/support/file_error.h"
#include "io/support/silence_libraries.h"

#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

constexpr std::string_view pngStart = "\x89PNG";
constexpr std::string_view jpegStart = "\xff\xd8\xff";
constexpr std::size_t maxJpegTrailer = 4096;

/// Whether a JPEG is truncated; libjpeg would fill the missing part with gray.
bool isTruncated(std::string_view jpeg)
{
    const std::size_t end = jpeg.rfind("\xff\xd9");
    return end == std::string_view::npos || end + maxJpegTrailer < jpeg.size();
}

core::Result<Raster> decode(std::string_view content, const std::string& path)
{
    if (content.starts_with(pngStart)) {
        return readPng(content, path);
    }
    if (!content.starts_with(jpegStart)) {
        return readTiff(path);
    }
    if (isTruncated(content)) {
        return fileError(path, messages::imageDamaged());
    }
    auto raster = readJpeg(content);
    return raster ? core::Result<Raster>(std::move(*raster)) : fileError(path, messages::imageUnusual());
}

bool isFinite(const Raster& raster)
{
    return std::all_of(raster.frames.begin(), raster.frames.end(), [](const core::ImageF& frame) {
        return std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); });
    });
}

}   // namespace

float Raster::luminance(float red, float green, float blue)
{
    if (red == green && green == blue) {
        return red;
    }
    wasColor = true;
    return 0.299F * red + 0.587F * green + 0.114F * blue;
}

bool looksLikeRaster(std::string_view content)
{
    return content.starts_with(pngStart) || content.starts_with(jpegStart) ||
           content.starts_with(std::string_view("II*\0", 4)) || content.starts_with(std::string_view("MM\0*", 4));
}

core::Result<Raster> readRaster(std::string_view content, const std::string& path)
{
    silenceLibraries();
    auto decoded = decode(content, path);
    if (!decoded) {
        return decoded;
    }
    Raster raster = std::move(decoded).value();
    if (const int orientation = exifOrientation(content); orientation > 1) {
        raster.orientation = orientation;
        raster.frames.front() = applyOrientation(raster.frames.front(), orientation);
    }
    return isFinite(raster) ? core::Result<Raster>(std::move(raster)) : fileError(path, messages::imageUnusual());
}

}   // namespace angiopose::io
