#include "io/angiogram_file.h"
#include "io/deidentify/remove_image_metadata.h"
#include "io/deidentify/remove_tiff_metadata.h"
#include "io/deidentify_files.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <tiffio.h>
#include <cstdint>
#include <vector>

using namespace angiopose;

namespace {

/// Storage variant of a test TIFF.
struct TiffKind {
    std::uint16_t bits = 8;
    std::uint16_t channels = 1;
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t compression = COMPRESSION_NONE;
    const char* mode = "w";
    int pages = 1;
};

constexpr std::uint32_t tiffWidth = 24, tiffHeight = 18;

std::vector<unsigned char> rowOf(const TiffKind& kind, int page, std::uint32_t y)
{
    std::vector<unsigned char> row(std::size_t{tiffWidth} * kind.channels * kind.bits / 8);
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] = static_cast<unsigned char>((i * 37 + y * 11 + static_cast<unsigned>(page) * 5) % 251);
    }
    return row;
}

void writePage(TIFF* file, const TiffKind& kind, int page)
{
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, tiffWidth);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, tiffHeight);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, kind.channels);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, kind.photometric);
    TIFFSetField(file, TIFFTAG_COMPRESSION, kind.compression);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 5);
    TIFFSetField(file, TIFFTAG_XRESOLUTION, 300.0);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, 300.0);
    for (const std::uint32_t tag :
         {TIFFTAG_IMAGEDESCRIPTION, TIFFTAG_ARTIST, TIFFTAG_COPYRIGHT, TIFFTAG_DOCUMENTNAME, TIFFTAG_HOSTCOMPUTER,
          TIFFTAG_MAKE, TIFFTAG_MODEL, TIFFTAG_PAGENAME, TIFFTAG_SOFTWARE, TIFFTAG_TARGETPRINTER}) {
        TIFFSetField(file, tag, "PLANTED");
    }
    TIFFSetField(file, TIFFTAG_DATETIME, "1950:01:02 PLANTED");
    TIFFSetField(file, TIFFTAG_XMLPACKET, 7, "PLANTED");
    TIFFSetField(file, TIFFTAG_ICCPROFILE, 7, "PLANTED");
    TIFFSetField(file, TIFFTAG_PHOTOSHOP, 7, "PLANTED");
    for (std::uint32_t y = 0; y < tiffHeight; ++y) {
        TIFFWriteScanline(file, rowOf(kind, page, y).data(), y, 0);
    }
    TIFFWriteDirectory(file);
}

std::string plantedTiff(const test::TemporaryFolder& folder, const TiffKind& kind)
{
    const std::string path = folder.file("planted.tif");
    TIFF* file = TIFFOpen(path.c_str(), kind.mode);
    for (int page = 0; page < kind.pages; ++page) {
        writePage(file, kind, page);
    }
    TIFFClose(file);
    return test::readText(path) + "PLANTED behind the end";
}

class StripTiff : public ::testing::TestWithParam<TiffKind> {
protected:
    test::TemporaryFolder folder;
};

TEST_P(StripTiff, KeepsEveryPixelAndNoWord)
{
    const TiffKind kind = GetParam();
    const std::string planted = plantedTiff(folder, kind);
    ASSERT_NE(planted.find("PLANTED"), std::string::npos);
    const auto stripped = io::removeImageMetadata(planted, "planted.tif");
    ASSERT_TRUE(stripped) << stripped.error().message.text();
    EXPECT_EQ(stripped.value().find("PLANTED"), std::string::npos);
    EXPECT_EQ(stripped.value().find("1950"), std::string::npos);
    const std::string path = folder.write("stripped.tif", stripped.value());
    TIFF* file = TIFFOpen(path.c_str(), "r");
    ASSERT_TRUE(file);
    std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize64(file)));
    for (int page = 0; page < kind.pages; ++page) {
        for (std::uint32_t y = 0; y < tiffHeight; ++y) {
            ASSERT_EQ(TIFFReadScanline(file, row.data(), y, 0), 1);
            ASSERT_EQ(row, rowOf(kind, page, y)) << page << ", " << y;
        }
        EXPECT_EQ(TIFFReadDirectory(file), page + 1 < kind.pages ? 1 : 0);
    }
    TIFFClose(file);
}

INSTANTIATE_TEST_SUITE_P(Kinds, StripTiff,
                         ::testing::Values(TiffKind{}, TiffKind{.bits = 16}, TiffKind{.bits = 16, .mode = "wb"},
                                           TiffKind{.channels = 3, .photometric = PHOTOMETRIC_RGB},
                                           TiffKind{.channels = 4, .photometric = PHOTOMETRIC_RGB},
                                           TiffKind{.photometric = PHOTOMETRIC_MINISWHITE, .pages = 3},
                                           TiffKind{.compression = COMPRESSION_LZW, .pages = 2},
                                           TiffKind{.bits = 16, .compression = COMPRESSION_ADOBE_DEFLATE},
                                           TiffKind{.compression = COMPRESSION_PACKBITS}, TiffKind{.mode = "w8"}));

TEST(StripTiffFiles, AreWrittenAsPicturesAndReadAlike)
{
    const test::TemporaryFolder folder;
    folder.write("DOE.tif", plantedTiff(folder, {.bits = 16, .pages = 2}));
    const io::Pseudonyms pseudonyms("a key of more than sixteen bytes");
    const auto done = io::deidentifyFiles({folder.file("DOE.tif")}, folder.file("out"), {}, pseudonyms);
    ASSERT_TRUE(done) << done.error().message.text();
    const auto before = io::readAngiogram(folder.file("DOE.tif"));
    const auto after = io::readAngiogram(folder.file("out/picture-1.tif"));
    ASSERT_TRUE(before && after);
    ASSERT_EQ(after.value().frameCount(), 2);
    EXPECT_EQ(before.value().frames[1].pixels, after.value().frames[1].pixels);
}

TEST(StripTiffFiles, OtherKindsAndDamagedOnesAreRefused)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("tiled.tif");
    TIFF* file = TIFFOpen(path.c_str(), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 32);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, 32);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
    std::vector<unsigned char> tile(256, 7);
    for (std::uint32_t n = 0; n < 4; ++n) {
        TIFFWriteEncodedTile(file, n, tile.data(), 256);
    }
    TIFFClose(file);
    const auto tiled = io::removeTiffMetadata(test::readText(path), "tiled.tif");
    ASSERT_FALSE(tiled);
    EXPECT_EQ(tiled.error().message.id(), "deidentify.tiff");
    const std::string whole = plantedTiff(folder, {});
    for (const std::size_t size : {4UL, 8UL, 60UL, whole.size() / 4}) {
        EXPECT_FALSE(io::removeTiffMetadata(std::string_view(whole).substr(0, size), "cut.tif")) << size;
    }
}

}   // namespace
