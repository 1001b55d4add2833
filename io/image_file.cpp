#include "io/image_file.h"

#include "io/messages/messages.h"
#include "io/raster/png_text.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <iterator>
#include <limits>

namespace angiopose::io {
namespace {

core::Status writePixels(const PngPixels& pixels, const std::string& path,
                         const std::map<std::string, std::string>& texts)
{
    const auto expected = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) *
                          static_cast<std::size_t>(pixels.channels) * static_cast<std::size_t>(pixels.bitDepth / 8);
    if (expected == 0 || pixels.bytes->size() != expected) {
        return fileError(path, messages::pictureMissing());
    }
    try {
        return writeAtomically(path, encodePng(pixels, texts));
    } catch (const std::exception&) {
        return fileError(path, messages::imageSize());
    }
}

constexpr double maxGray = 65535.0;

/// Formats a number with nine digits, which represent a float exactly.
std::string slopeText(double value)
{
    char text[40];
    const auto written = std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 9);
    return {text, written.ptr};
}

/// Mapping from gray levels to values: value = slope · gray + offset.
struct GrayScale {
    double slope = 1.0;
    double offset = 0.0;
};

GrayScale grayScaleOf(const core::Angiogram& run)
{
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    bool isInteger = true;
    for (const core::ImageF& frame : run.frames) {
        for (const float value : frame.pixels) {
            least = std::min<double>(least, value);
            most = std::max<double>(most, value);
            isInteger = isInteger && value == std::floor(value);
        }
    }
    if (isInteger && least >= 0.0 && most <= maxGray) {
        return {};
    }
    return {most > least ? (most - least) / maxGray : 1.0, least};
}

}   // namespace

core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts, double dotsPerInch)
{
    return writePixels({image.width, image.height, 3, &image.rgb, 8, dotsPerInch}, path, texts);
}

core::Status writeGrayPng(const core::Angiogram& run, int frame, const std::string& path,
                          std::map<std::string, std::string> texts, double dotsPerInch)
{
    const core::ImageF& picture = run.frames[static_cast<std::size_t>(frame)];
    const GrayScale scale = grayScaleOf(run);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(2 * picture.pixels.size());
    for (const float value : picture.pixels) {
        const auto gray = static_cast<unsigned>(
            std::clamp<long>(std::lround((value - scale.offset) / scale.slope), 0, static_cast<long>(maxGray)));
        bytes.push_back(static_cast<std::uint8_t>(gray >> 8U));
        bytes.push_back(static_cast<std::uint8_t>(gray & 0xffU));
    }
    texts["Values"] = "grey * " + slopeText(scale.slope) + " + " + slopeText(scale.offset);
    return writePixels({picture.width, picture.height, 1, &bytes, 16, dotsPerInch}, path, texts);
}

core::Status writePng(const core::Mask2d& mask, const std::string& path)
{
    std::vector<std::uint8_t> levels(mask.pixels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i] = mask.pixels[i] != 0 ? 255 : 0;
    }
    return writePixels({mask.width, mask.height, 1, &levels}, path, {});
}

}   // namespace angiopose::io
