#include "io/deidentify/strip_tiff.h"

#include "io/messages/says.h"
#include "io/messages/says_deidentify.h"
#include "io/support/file_error.h"
#include "io/support/quiet_libraries.h"

#include <tiffio.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::io {
namespace {

constexpr std::uint32_t maxTiffSide = 32'768;
constexpr std::size_t maxTiffBytes = std::size_t{1} << 31;

/// A file in memory, as libtiff asks for one.
class MemoryFile {
public:
    MemoryFile() = default;
    explicit MemoryFile(std::string_view content) : content_(content) {}

    tmsize_t read(void* into, tmsize_t size)
    {
        const std::size_t left = at_ < content_.size() ? content_.size() - at_ : 0;
        const std::size_t count = std::min(left, static_cast<std::size_t>(size));
        std::memcpy(into, content_.data() + std::min(at_, content_.size()), count);
        at_ += count;
        return static_cast<tmsize_t>(count);
    }
    tmsize_t write(const void* from, tmsize_t size)
    {
        const auto count = static_cast<std::size_t>(size);
        if (at_ + count > content_.size()) {
            content_.resize(at_ + count, '\0');
        }
        std::memcpy(content_.data() + at_, from, count);
        at_ += count;
        return size;
    }
    toff_t seek(toff_t offset, int whence)
    {
        const std::size_t base = whence == SEEK_CUR ? at_ : whence == SEEK_END ? content_.size() : 0;
        at_ = base + static_cast<std::size_t>(offset);
        return at_;
    }
    toff_t size() const { return content_.size(); }
    std::string take() { return std::move(content_); }

private:
    std::string content_;
    std::size_t at_ = 0;
};

struct CloseMemoryTiff {
    void operator()(TIFF* file) const { TIFFClose(file); }
};
using MemoryTiff = std::unique_ptr<TIFF, CloseMemoryTiff>;

MemoryTiff openTiff(MemoryFile& file, const char* mode)
{
    return MemoryTiff(TIFFClientOpen(
        "memory", mode, &file,
        [](thandle_t handle, void* into, tmsize_t size) { return static_cast<MemoryFile*>(handle)->read(into, size); },
        [](thandle_t handle, void* from, tmsize_t size) { return static_cast<MemoryFile*>(handle)->write(from, size); },
        [](thandle_t handle, toff_t offset, int whence) {
            return static_cast<MemoryFile*>(handle)->seek(offset, whence);
        },
        [](thandle_t) { return 0; }, [](thandle_t handle) { return static_cast<MemoryFile*>(handle)->size(); },
        [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}));
}

/// What says how pixels are shown; all numbers.
struct TiffLayout {
    std::uint32_t width = 0, height = 0;
    std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t planes = PLANARCONFIG_CONTIG, compression = COMPRESSION_NONE, orientation = ORIENTATION_TOPLEFT;
};

std::optional<TiffLayout> layoutOf(TIFF* file)
{
    TiffLayout layout;
    TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &layout.width);
    TIFFGetField(file, TIFFTAG_IMAGELENGTH, &layout.height);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &layout.channels);
    TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &layout.bits);
    TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &layout.format);
    TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &layout.planes);
    TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &layout.compression);
    TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &layout.orientation);
    TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &layout.photometric);
    const bool isGrey = layout.channels <= 2 &&
                        (layout.photometric == PHOTOMETRIC_MINISBLACK || layout.photometric == PHOTOMETRIC_MINISWHITE);
    const bool isColour = (layout.channels == 3 || layout.channels == 4) && layout.photometric == PHOTOMETRIC_RGB;
    const bool isPalette = layout.channels == 1 && layout.photometric == PHOTOMETRIC_PALETTE && layout.bits == 8;
    const bool isKnownSample = layout.format == SAMPLEFORMAT_IEEEFP
                                   ? layout.bits == 32
                                   : layout.format == SAMPLEFORMAT_UINT && (layout.bits == 8 || layout.bits == 16);
    const bool isPlausible = layout.channels > 0 && layout.width > 0 && layout.height > 0 &&
                             layout.width <= maxTiffSide && layout.height <= maxTiffSide;
    if (!(isGrey || isColour || isPalette) || !isKnownSample || !isPlausible || TIFFIsTiled(file) ||
        layout.planes != PLANARCONFIG_CONTIG) {
        return std::nullopt;
    }
    const std::uint64_t rowBytes = std::uint64_t{layout.width} * layout.channels * layout.bits / 8;
    return TIFFScanlineSize64(file) == rowBytes ? std::optional(layout) : std::nullopt;
}

void copyLayout(TIFF* from, const TiffLayout& layout, TIFF* to)
{
    const std::uint16_t compression = layout.compression == COMPRESSION_NONE || !TIFFIsCODECConfigured(COMPRESSION_LZW)
                                          ? COMPRESSION_NONE
                                          : COMPRESSION_LZW;
    TIFFSetField(to, TIFFTAG_IMAGEWIDTH, layout.width);
    TIFFSetField(to, TIFFTAG_IMAGELENGTH, layout.height);
    TIFFSetField(to, TIFFTAG_SAMPLESPERPIXEL, layout.channels);
    TIFFSetField(to, TIFFTAG_BITSPERSAMPLE, layout.bits);
    TIFFSetField(to, TIFFTAG_SAMPLEFORMAT, layout.format);
    TIFFSetField(to, TIFFTAG_PHOTOMETRIC, layout.photometric);
    TIFFSetField(to, TIFFTAG_PLANARCONFIG, layout.planes);
    TIFFSetField(to, TIFFTAG_ORIENTATION, layout.orientation);
    TIFFSetField(to, TIFFTAG_COMPRESSION, compression);
    TIFFSetField(to, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(to, 0));
    std::uint16_t extraCount = 0;
    std::uint16_t* extras = nullptr;
    if (TIFFGetField(from, TIFFTAG_EXTRASAMPLES, &extraCount, &extras) == 1 && extraCount > 0) {
        TIFFSetField(to, TIFFTAG_EXTRASAMPLES, extraCount, extras);
    }
    std::array<std::uint16_t*, 3> colours{};
    if (layout.photometric == PHOTOMETRIC_PALETTE &&
        TIFFGetField(from, TIFFTAG_COLORMAP, &colours[0], &colours[1], &colours[2]) == 1) {
        TIFFSetField(to, TIFFTAG_COLORMAP, colours[0], colours[1], colours[2]);
    }
    float x = 0.0F, y = 0.0F;
    std::uint16_t unit = RESUNIT_NONE;
    if (TIFFGetField(from, TIFFTAG_XRESOLUTION, &x) == 1 && TIFFGetField(from, TIFFTAG_YRESOLUTION, &y) == 1) {
        TIFFGetFieldDefaulted(from, TIFFTAG_RESOLUTIONUNIT, &unit);
        TIFFSetField(to, TIFFTAG_XRESOLUTION, x);
        TIFFSetField(to, TIFFTAG_YRESOLUTION, y);
        TIFFSetField(to, TIFFTAG_RESOLUTIONUNIT, unit);
    }
}

bool copyRows(TIFF* from, const TiffLayout& layout, TIFF* to)
{
    std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize64(from)));
    for (std::uint32_t y = 0; y < layout.height; ++y) {
        if (TIFFReadScanline(from, row.data(), y, 0) != 1 || TIFFWriteScanline(to, row.data(), y, 0) != 1) {
            return false;
        }
    }
    return TIFFWriteDirectory(to) == 1;
}

/// A smaller version of another page.
bool isThumbnail(TIFF* file)
{
    std::uint32_t kind = 0;
    TIFFGetFieldDefaulted(file, TIFFTAG_SUBFILETYPE, &kind);
    return (kind & FILETYPE_REDUCEDIMAGE) != 0;
}

}   // namespace

bool looksLikeTiff(std::string_view content)
{
    return content.starts_with(std::string_view("II*\0", 4)) || content.starts_with(std::string_view("MM\0*", 4)) ||
           content.starts_with(std::string_view("II+\0", 4)) || content.starts_with(std::string_view("MM\0+", 4));
}

core::Result<std::string> strippedTiff(std::string_view tiff, const std::string& path)
{
    quietLibraries();
    MemoryFile input(tiff);
    MemoryFile output;
    const MemoryTiff from = openTiff(input, "rm");
    MemoryTiff to = openTiff(output, "wm");
    if (!from || !to) {
        return fileError(path, says::imageDamaged());
    }
    std::size_t pages = 0;
    std::uint64_t bytes = 0;
    for (bool hasPage = true; hasPage; hasPage = TIFFReadDirectory(from.get()) == 1) {
        if (isThumbnail(from.get())) {
            continue;
        }
        const auto layout = layoutOf(from.get());
        bytes += layout ? std::uint64_t{layout->height} * TIFFScanlineSize64(from.get()) : 0;
        if (!layout || bytes > maxTiffBytes) {
            return fileError(path, says::tiffNotStripped());
        }
        copyLayout(from.get(), *layout, to.get());
        if (!copyRows(from.get(), *layout, to.get())) {
            return fileError(path, says::imageDamaged());
        }
        ++pages;
    }
    to.reset();
    return pages > 0 ? core::Result<std::string>(output.take()) : fileError(path, says::imageDamaged());
}

}   // namespace angiopose::io
