#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/deidentify/remove_image_metadata.h"
#include "io/image_file.h"
#include "io/messages/messages.h"
#include "io/raster/image_orientation.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <tiffio.h>
#include <zlib.h>
#include <algorithm>
#include <cstdio>

using namespace angiopose;

// Plain images are displayed as their orientation tag requires, for every format and every use.

namespace {

constexpr int shownWidth = 24, shownHeight = 16;

/// Bright at the upper right, which no rotation or mirroring maps to itself.
float shownGray(int x, int y)
{
    return x >= 16 && y < 8 ? 200.0F : 40.0F;
}

/// Displayed position of a stored pixel: tag 274 names the sides of the first row and the first column.
std::pair<int, int> placeOf(int column, int row, int orientation)
{
    const int right = shownWidth - 1, bottom = shownHeight - 1;
    switch (orientation) {
        case 2:
            return {right - column, row};
        case 3:
            return {right - column, bottom - row};
        case 4:
            return {column, bottom - row};
        case 5:
            return {row, column};
        case 6:
            return {right - row, column};
        case 7:
            return {right - row, bottom - column};
        case 8:
            return {row, bottom - column};
        default:
            return {column, row};
    }
}

core::ImageF storedFor(int orientation)
{
    const bool isTurned = orientation >= 5;
    core::ImageF stored(isTurned ? shownHeight : shownWidth, isTurned ? shownWidth : shownHeight);
    for (int y = 0; y < stored.height; ++y) {
        for (int x = 0; x < stored.width; ++x) {
            const auto [column, row] = placeOf(x, y, orientation);
            stored.at(x, y) = shownGray(column, row);
        }
    }
    return stored;
}

std::vector<unsigned char> bytesOf(const core::ImageF& image)
{
    return {image.pixels.begin(), image.pixels.end()};
}

void addTiffPage(TIFF* file, const core::ImageF& image, int orientation, std::uint32_t kind)
{
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, image.width);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, image.height);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(file, TIFFTAG_ORIENTATION, orientation);
    TIFFSetField(file, TIFFTAG_SUBFILETYPE, kind);
    std::vector<unsigned char> bytes = bytesOf(image);
    for (int y = 0; y < image.height; ++y) {
        TIFFWriteScanline(file, bytes.data() + static_cast<std::ptrdiff_t>(y) * image.width,
                          static_cast<std::uint32_t>(y), 0);
    }
    TIFFWriteDirectory(file);
}

std::string tiffOf(const std::string& path, const std::vector<std::pair<core::ImageF, std::uint32_t>>& pages,
                   int orientation = 1)
{
    TIFF* file = TIFFOpen(path.c_str(), "w");
    for (const auto& [image, kind] : pages) {
        addTiffPage(file, image, orientation, kind);
    }
    TIFFClose(file);
    return path;
}

std::string plainJpeg(const core::ImageF& image)
{
    jpeg_compress_struct encoder;
    jpeg_error_mgr errors;
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char* written = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &written, &size);
    encoder.image_width = static_cast<JDIMENSION>(image.width);
    encoder.image_height = static_cast<JDIMENSION>(image.height);
    encoder.input_components = 1;
    encoder.in_color_space = JCS_GRAYSCALE;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 100, TRUE);
    jpeg_start_compress(&encoder, TRUE);
    std::vector<unsigned char> bytes = bytesOf(image);
    for (int y = 0; y < image.height; ++y) {
        JSAMPROW row = bytes.data() + static_cast<std::ptrdiff_t>(y) * image.width;
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    std::string content(reinterpret_cast<const char*>(written), size);
    jpeg_destroy_compress(&encoder);
    std::free(written);
    return content;
}

/// An EXIF directory of two entries, the second of which is the orientation.
std::string exifBytes(int orientation, bool isLittle)
{
    const std::string first = isLittle ? std::string("\x0f\x01\x02\0\x02\0\0\0A\0\0\0", 12)
                                       : std::string("\x01\x0f\0\x02\0\0\0\x02\x41\0\0\0", 12);
    std::string second = isLittle ? std::string("\x12\x01\x03\0\x01\0\0\0\0\0\0\0", 12)
                                  : std::string("\x01\x12\0\x03\0\0\0\x01\0\0\0\0", 12);
    second[isLittle ? 8 : 9] = static_cast<char>(orientation);
    return (isLittle ? std::string("II*\0\x08\0\0\0\x02\0", 10) : std::string("MM\0*\0\0\0\x08\0\x02", 10)) + first +
           second + std::string(4, '\0');
}

std::string jpegOf(const core::ImageF& image, const std::string& exif)
{
    std::string content = plainJpeg(image);
    const std::string segment = std::string("Exif\0\0", 6) + exif;
    return content.insert(2, std::string("\xff\xe1\0", 3) + static_cast<char>(segment.size() + 2) + segment);
}

/// Writes the chunk after the pixels, which is also allowed.
std::string pngOf(const test::TemporaryFolder& folder, const core::ImageF& image, const std::string& exif)
{
    core::Angiogram run;
    run.frames = {image};
    EXPECT_TRUE(io::writeGrayPng(run, 0, folder.file("plain.png"), {}));
    std::string content = test::readText(folder.file("plain.png"));
    const std::string chunk = "eXIf" + exif;
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(chunk.data()), chunk.size());
    std::string whole{0, 0, 0, static_cast<char>(exif.size())};
    whole += chunk;
    for (int shift = 24; shift >= 0; shift -= 8) {
        whole += static_cast<char>(sum >> shift);
    }
    return content.insert(content.size() - 12, whole);
}

void expectShown(const std::string& path, int orientation)
{
    const auto read = io::readAngiogram(path);
    ASSERT_TRUE(read) << read.error().message;
    const core::ImageF& frame = read.value().frames.front();
    ASSERT_EQ(frame.width, shownWidth) << path << " " << orientation;
    ASSERT_EQ(frame.height, shownHeight);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            ASSERT_NEAR(frame.at(x, y), shownGray(x, y), 2.0F) << path << " " << orientation << " at " << x << "," << y;
        }
    }
    const bool isNamed = std::ranges::any_of(
        read.value().warnings, [](const core::Message& each) { return each.is(io::messages::pictureTurned); });
    EXPECT_EQ(isNamed, orientation != 1);
}

TEST(PictureOrientation, IsAppliedToEveryKindOfPicture)
{
    const test::TemporaryFolder folder;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const core::ImageF stored = storedFor(orientation);
        expectShown(tiffOf(folder.file("o.tif"), {{stored, 0}}, orientation), orientation);
        for (const bool isLittle : {true, false}) {
            const std::string exif = exifBytes(orientation, isLittle);
            expectShown(folder.write("o.jpg", jpegOf(stored, exif)), orientation);
            expectShown(folder.write("o.png", pngOf(folder, stored, exif)), orientation);
        }
    }
}

TEST(PictureOrientation, IsAsStoredWhereTheTagIsNone)
{
    const test::TemporaryFolder folder;
    const std::string exif = exifBytes(6, true);
    expectShown(folder.write("a.jpg", jpegOf(storedFor(1), exifBytes(0, true))), 1);
    expectShown(folder.write("b.jpg", jpegOf(storedFor(1), exifBytes(9, false))), 1);
    for (std::size_t size = 0; size + 12 < exif.size(); ++size) {   // without the value
        EXPECT_EQ(io::exifOrientation(jpegOf(storedFor(1), exif.substr(0, size))), 1) << size;
    }
}

TEST(PictureOrientation, HoldsForMasksToo)
{
    const test::TemporaryFolder folder;
    core::ImageF mask(30, 80, 0.0F);   // a line along the upper edge as displayed, mirrored and rotated as stored
    for (int y = 5; y < 75; ++y) {
        mask.at(4, y) = 255.0F;
    }
    const auto curves = io::readCenterline2d(tiffOf(folder.file("mask.tif"), {{mask, 0}}, 5));
    ASSERT_TRUE(curves) << curves.error().message;
    for (const auto& curve : curves.value().curves) {
        for (const auto& point : curve.pointsPx) {
            EXPECT_NEAR(point.y(), 4.0, 1.0);
        }
    }
    const auto two = io::readCenterline2d(tiffOf(folder.file("two.tif"), {{mask, 0}, {mask, 0}}));
    ASSERT_FALSE(two);
    EXPECT_TRUE(two.error().message.is(io::messages::centerlineMaskPages)) << two.error().message;
}

TEST(PictureOrientation, StaysWhereAPictureIsFreedOfWhatIsBeside)
{
    const test::TemporaryFolder folder;
    for (const int orientation : {1, 2, 5, 6, 8}) {
        const core::ImageF stored = storedFor(orientation);
        const std::string exif = exifBytes(orientation, true);
        for (const auto& [name, picture] :
             {std::pair("o.jpg", jpegOf(stored, exif)), std::pair("o.png", pngOf(folder, stored, exif))}) {
            const auto stripped = io::removeImageMetadata(picture, name);
            ASSERT_TRUE(stripped) << name;
            EXPECT_EQ(stripped.value().find(exif), std::string::npos) << name;
            expectShown(folder.write(name, stripped.value()), orientation);
        }
    }
}

TEST(TiffPages, AreFramesApartFromThumbnailsAndMasks)
{
    const test::TemporaryFolder folder;
    const core::ImageF frame = storedFor(1), small(12, 8, 7.0F);
    const auto run = io::readAngiogram(tiffOf(folder.file("run.tif"), {{small, FILETYPE_REDUCEDIMAGE},
                                                                       {frame, FILETYPE_PAGE},
                                                                       {frame, FILETYPE_MASK},
                                                                       {frame, FILETYPE_PAGE},
                                                                       {small, FILETYPE_REDUCEDIMAGE},
                                                                       {frame, 0}}));
    ASSERT_TRUE(run) << run.error().message;
    EXPECT_EQ(run.value().frameCount(), 3);
    EXPECT_EQ(run.value().frames.front().pixels, frame.pixels);
    EXPECT_TRUE(io::readAngiogram(tiffOf(folder.file("only.tif"), {{frame, FILETYPE_REDUCEDIMAGE}})));
}

TEST(TiffPages, OfTwoSizesAreNamedWithBoth)
{
    const test::TemporaryFolder folder;
    const auto read =
        io::readAngiogram(tiffOf(folder.file("two.tif"), {{storedFor(1), 0}, {core::ImageF(12, 9, 7.0F), 0}}));
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.text().find("page 2 is 12 × 9 pixels, but the first page is 24 × 16"),
              std::string::npos)
        << read.error().message;
}

TEST(TiffPages, ThatCannotBeReadDoNotVanish)
{
    const test::TemporaryFolder folder;
    const std::string path = tiffOf(folder.file("run.tif"), {{storedFor(1), 0}, {storedFor(1), 0}});
    std::string content = test::readText(path);
    std::uint32_t directory = 0, next = 0;   // written by libtiff in this machine's byte order
    std::copy_n(content.data() + 4, 4, reinterpret_cast<char*>(&directory));
    std::uint16_t count = 0;
    std::copy_n(content.data() + directory, 2, reinterpret_cast<char*>(&count));
    const std::size_t place = directory + 2 + 12 * std::size_t{count};
    std::copy_n(content.data() + place, 4, reinterpret_cast<char*>(&next));
    ASSERT_GT(next, 0U);
    content.replace(place, 4, "\xff\xff\xff\x7f");
    EXPECT_FALSE(io::readAngiogram(folder.write("cut.tif", content)));
}

}   // namespace
