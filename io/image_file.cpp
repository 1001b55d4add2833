#include "io/image_file.h"

#include "io/messages/says.h"
#include "io/raster/png_text.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"

#include <exception>

namespace angiopose::io {
namespace {

core::Status writePixels(const PngPixels& pixels, const std::string& path,
                         const std::map<std::string, std::string>& texts)
{
    const auto expected = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) *
                          static_cast<std::size_t>(pixels.channels);
    if (expected == 0 || pixels.bytes->size() != expected) {
        return fileError(path, says::pictureMissing());
    }
    try {
        return writeAtomically(path, encodedPng(pixels, texts));
    } catch (const std::exception&) {
        return fileError(path, says::imageSize());
    }
}

}   // namespace

core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts)
{
    return writePixels({image.width, image.height, 3, &image.rgb}, path, texts);
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