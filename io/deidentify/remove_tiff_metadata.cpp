#include "io/deidentify/remove_tiff_metadata.h"

#include "io/messages/messages.h"
#include "io/raster/tiff_page.h"
#include "io/support/file_error.h"
#include "io/support/silence_libraries.h"

#include <tiffio.h>
#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace angiopose::io {
namespace {

constexpr std::size_t maxTiffBytes = std::size_t{1} << 31;

/// An in-memory file for libtiff.
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

TiffFile openTiff(MemoryFile& file, const char* mode)
{
    return TiffFile(TIFFClientOpen(
        "memory", mode, &file,
        [](thandle_t handle, void* into, tmsize_t size) { return static_cast<MemoryFile*>(handle)->read(into, size); },
        [](thandle_t handle, void* from, tmsize_t size) { return static_cast<MemoryFile*>(handle)->write(from, size); },
        [](thandle_t handle, toff_t offset, int whence) {
            return static_cast<MemoryFile*>(handle)->seek(offset, whence);
        },
        [](thandle_t) { return 0; }, [](thandle_t handle) { return static_cast<MemoryFile*>(handle)->size(); },
        [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}));
}

void copyPage(TIFF* from, const TiffPage& page, TIFF* to)
{
    const std::uint16_t compression = page.compression == COMPRESSION_NONE || !TIFFIsCODECConfigured(COMPRESSION_LZW)
                                          ? COMPRESSION_NONE
                                          : COMPRESSION_LZW;
    TIFFSetField(to, TIFFTAG_IMAGEWIDTH, page.width);
    TIFFSetField(to, TIFFTAG_IMAGELENGTH, page.height);
    TIFFSetField(to, TIFFTAG_SAMPLESPERPIXEL, page.channels);
    TIFFSetField(to, TIFFTAG_BITSPERSAMPLE, page.bits);
    TIFFSetField(to, TIFFTAG_SAMPLEFORMAT, page.format);
    TIFFSetField(to, TIFFTAG_PHOTOMETRIC, page.photometric);
    TIFFSetField(to, TIFFTAG_PLANARCONFIG, page.planes);
    TIFFSetField(to, TIFFTAG_ORIENTATION, page.orientation);
    TIFFSetField(to, TIFFTAG_COMPRESSION, compression);
    TIFFSetField(to, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(to, 0));
    std::uint16_t extraCount = 0;
    std::uint16_t* extras = nullptr;
    if (TIFFGetField(from, TIFFTAG_EXTRASAMPLES, &extraCount, &extras) == 1 && extraCount > 0) {
        TIFFSetField(to, TIFFTAG_EXTRASAMPLES, extraCount, extras);
    }
    std::array<std::uint16_t*, 3> colors{};
    if (page.isPalette() && TIFFGetField(from, TIFFTAG_COLORMAP, &colors[0], &colors[1], &colors[2]) == 1) {
        TIFFSetField(to, TIFFTAG_COLORMAP, colors[0], colors[1], colors[2]);
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

bool copyRows(TIFF* from, const TiffPage& page, TIFF* to)
{
    std::vector<unsigned char> row(page.rowBytes());
    for (std::uint32_t y = 0; y < page.height; ++y) {
        if (TIFFReadScanline(from, row.data(), y, 0) != 1 || TIFFWriteScanline(to, row.data(), y, 0) != 1) {
            return false;
        }
    }
    return TIFFWriteDirectory(to) == 1;
}

}   // namespace

bool looksLikeTiff(std::string_view content)
{
    return content.starts_with(std::string_view("II*\0", 4)) || content.starts_with(std::string_view("MM\0*", 4)) ||
           content.starts_with(std::string_view("II+\0", 4)) || content.starts_with(std::string_view("MM\0+", 4));
}

core::Result<std::string> removeTiffMetadata(std::string_view tiff, const std::string& path)
{
    silenceLibraries();
    MemoryFile input(tiff);
    MemoryFile output;
    const TiffFile from = openTiff(input, "rm");
    TiffFile to = openTiff(output, "wm");
    if (!from || !to) {
        return fileError(path, messages::imageDamaged());
    }
    std::size_t pages = 0;
    std::uint64_t bytes = 0;
    for (bool hasPage = true; hasPage; hasPage = TIFFReadDirectory(from.get()) == 1) {
        if (isAuxiliaryPage(from.get())) {
            continue;
        }
        const auto page = readTiffPage(from.get());
        bytes += page ? std::uint64_t{page->height} * TIFFScanlineSize64(from.get()) : 0;
        if (!page || bytes > maxTiffBytes) {
            return fileError(path, messages::tiffNotStripped());
        }
        copyPage(from.get(), *page, to.get());
        if (!copyRows(from.get(), *page, to.get())) {
            return fileError(path, messages::imageDamaged());
        }
        ++pages;
    }
    to.reset();
    return pages > 0 ? core::Result<std::string>(output.take()) : fileError(path, messages::imageDamaged());
}

}   // namespace angiopose::io
