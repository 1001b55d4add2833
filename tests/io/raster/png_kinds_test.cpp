#include "io/angiogram_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <png.h>
#include <functional>

using namespace angiopose;

// Every kind of PNG gives the gray values that it encodes.

namespace {

constexpr std::size_t side = 16;

struct PngKind {
    int color = PNG_COLOR_TYPE_GRAY;
    int depth = 8;
    int interlace = PNG_INTERLACE_NONE;
    /// Adds chunks before the pixels.
    std::function<void(png_struct*, png_info*)> adorn = [](png_struct*, png_info*) {};
};

/// Writes a PNG with `rowBytes` as every row.
std::string writtenPng(const test::TemporaryFolder& folder, const PngKind& kind, std::vector<png_byte> rowBytes)
{
    const std::string path = folder.file("kind.png");
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_struct* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_info* info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, side, side, kind.depth, kind.color, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    kind.adorn(png, info);
    png_write_info(png, info);
    std::vector<png_byte*> rows(side, rowBytes.data());
    png_write_image(png, rows.data());
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
    return path;
}

/// Gray value of the third pixel of the second row.
float thirdPixel(const std::string& path)
{
    const auto read = io::readAngiogram(path);
    EXPECT_TRUE(read) << read.error().message.text();
    return read ? read.value().frames.front().at(2, 1) : -1.0F;
}

std::vector<png_byte> repeated(std::initializer_list<png_byte> pixel)
{
    std::vector<png_byte> row;
    for (std::size_t x = 0; x < side; ++x) {
        row.insert(row.end(), pixel);
    }
    return row;
}

TEST(PngKinds, GrayOfAllDepthsSpansItsRange)
{
    const test::TemporaryFolder folder;
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.depth = 1}, repeated({0x20}))), 255.0F);
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.depth = 2}, repeated({0x08}))), 170.0F);
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.depth = 4}, repeated({0x33}))), 51.0F);
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.depth = 8}, repeated({77}))), 77.0F);
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.depth = 16}, repeated({0x12, 0x34}))), 0x1234);
}

TEST(PngKinds, InterlacedRowsFindTheirPlace)
{
    const test::TemporaryFolder folder;
    std::vector<png_byte> row;
    for (png_byte x = 0; x < side; ++x) {
        row.push_back(static_cast<png_byte>(10 * x));
    }
    EXPECT_EQ(thirdPixel(writtenPng(folder, {.interlace = PNG_INTERLACE_ADAM7}, row)), 20.0F);
}

TEST(PngKinds, ColorsBecomeLuminance)
{
    const test::TemporaryFolder folder;
    const std::string wide = writtenPng(folder, {PNG_COLOR_TYPE_RGB, 16}, repeated({1, 0, 2, 0, 3, 0}));
    EXPECT_FLOAT_EQ(thirdPixel(wide), 0.299F * 256 + 0.587F * 512 + 0.114F * 768);
    EXPECT_EQ(io::readAngiogram(wide).value().warnings.front().id(), "image.colour-to-grey");

    PngKind palette{PNG_COLOR_TYPE_PALETTE, 4};
    palette.adorn = [](png_struct* png, png_info* info) {
        const png_color colors[] = {{0, 0, 0}, {90, 90, 90}};
        png_set_PLTE(png, info, colors, 2);
    };
    EXPECT_EQ(thirdPixel(writtenPng(folder, palette, repeated({0x11}))), 90.0F);
}

TEST(PngKinds, TransparencyIsNotedAndIgnored)
{
    const test::TemporaryFolder folder;
    const std::string grayAlpha = writtenPng(folder, {PNG_COLOR_TYPE_GRAY_ALPHA}, repeated({123, 0}));
    EXPECT_EQ(thirdPixel(grayAlpha), 123.0F);
    EXPECT_EQ(io::readAngiogram(grayAlpha).value().warnings.front().id(), "image.transparency-ignored");
    EXPECT_EQ(thirdPixel(writtenPng(folder, {PNG_COLOR_TYPE_RGB_ALPHA}, repeated({9, 9, 9, 128}))), 9.0F);

    PngKind keyed;
    keyed.adorn = [](png_struct* png, png_info* info) {
        png_color_16 transparent{};
        transparent.gray = 5;
        png_set_tRNS(png, info, nullptr, 0, &transparent);
    };
    EXPECT_EQ(thirdPixel(writtenPng(folder, keyed, repeated({5}))), 5.0F);
}

TEST(PngKinds, BitsThatMeanNothingAreTakenOff)
{
    const test::TemporaryFolder folder;
    PngKind twelveBits{PNG_COLOR_TYPE_GRAY, 16};
    twelveBits.adorn = [](png_struct* png, png_info* info) {
        png_color_8 bits{};
        bits.gray = 12;
        png_set_sBIT(png, info, &bits);
    };
    EXPECT_EQ(thirdPixel(writtenPng(folder, twelveBits, repeated({0xab, 0xc0}))), 0xabc);
}

TEST(PngKinds, AWrongChecksumIsDamageWhereverItIs)
{
    const test::TemporaryFolder folder;
    PngKind commented;
    commented.adorn = [](png_struct* png, png_info* info) {
        png_text text{};
        char key[] = "Comment", words[] = "about the picture";
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = key;
        text.text = words;
        png_set_text(png, info, &text, 1);
    };
    const std::string path = writtenPng(folder, commented, repeated({1}));
    std::string content = test::readText(path);
    content[content.find("about")] = 'A';
    const auto read = io::readAngiogram(folder.write("wrong.png", content));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message.id(), "image.damaged");
}

}   // namespace
