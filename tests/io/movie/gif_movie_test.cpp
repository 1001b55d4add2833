#include "io/movie/gif_palette.h"
#include "io/movie/movie_writer.h"
#include "tests/io/movie/movie_pictures.h"
#include "tests/support/for_each.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

struct Shown {
    std::vector<core::ColorImage> pictures;   ///< composited as by a viewer
    std::vector<int> delays;
    std::vector<int> areas;   ///< pixels of each partial frame
    bool isEndless = false;
    std::string comment;
};

void readExtensions(const SavedImage& image, Shown& shown)
{
    for (int i = 0; i < image.ExtensionBlockCount; ++i) {
        const ExtensionBlock& block = image.ExtensionBlocks[i];
        const std::string bytes(reinterpret_cast<const char*>(block.Bytes), static_cast<std::size_t>(block.ByteCount));
        shown.isEndless = shown.isEndless || bytes == "NETSCAPE2.0";
        shown.comment += block.Function == COMMENT_EXT_FUNC_CODE ? bytes : std::string();
    }
}

/// Reads the movie with giflib and composites its frames explicitly.
Shown shownBy(const std::string& path)
{
    Shown shown;
    int error = 0;
    GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
    EXPECT_NE(gif, nullptr);
    EXPECT_EQ(DGifSlurp(gif), GIF_OK);
    core::ColorImage canvas{gif->SWidth, gif->SHeight,
                            std::vector<std::uint8_t>(3 * static_cast<std::size_t>(gif->SWidth * gif->SHeight))};
    for (int k = 0; k < gif->ImageCount; ++k) {
        const SavedImage& image = gif->SavedImages[k];
        readExtensions(image, shown);
        GraphicsControlBlock control{};
        DGifSavedExtensionToGCB(gif, k, &control);
        const GifImageDesc& place = image.ImageDesc;
        for (int i = 0; i < place.Width * place.Height; ++i) {
            if (image.RasterBits[i] != control.TransparentColor) {
                const GifColorType color = place.ColorMap->Colors[image.RasterBits[i]];
                const int x = place.Left + i % place.Width, y = place.Top + i / place.Width;
                std::uint8_t* at = &canvas.rgb[3 * static_cast<std::size_t>(y * canvas.width + x)];
                at[0] = color.Red, at[1] = color.Green, at[2] = color.Blue;
            }
        }
        shown.pictures.push_back(canvas);
        shown.delays.push_back(control.DelayTime);
        shown.areas.push_back(place.Width * place.Height);
    }
    DGifCloseFile(gif, &error);
    return shown;
}

int largestError(const core::ColorImage& a, const core::ColorImage& b)
{
    int most = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        most = std::max(most, std::abs(a.rgb[i] - b.rgb[i]));
    }
    return most;
}

class GifMovie : public testing::Test {
protected:
    GifMovie() { fs::create_directories(folder_); }
    ~GifMovie() override { fs::remove_all(folder_); }

    Shown written(const std::vector<core::ColorImage>& pictures, double ms)
    {
        auto movie =
            MovieWriter::create(path_, {pictures[0].width, pictures[0].height}, {"Title", {{"Program", "test"}}});
        EXPECT_TRUE(movie);
        for (const core::ColorImage& picture : pictures) {
            EXPECT_TRUE(movie.value()->add(picture, ms));
        }
        EXPECT_TRUE(movie.value()->finish());
        return shownBy(path_);
    }

    fs::path folder_ = fs::temp_directory_path() / ("gif-" + std::to_string(::getpid()));
    std::string path_ = (folder_ / "movie.gif").string();
};

TEST_F(GifMovie, ShowsWhatWasGiven)
{
    std::vector<core::ColorImage> pictures;
    for (int i = 0; i < 8; ++i) {
        pictures.push_back(moviePicture(161, 203, i));
    }
    const Shown shown = written(pictures, 40.0);
    ASSERT_EQ(shown.pictures.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_LE(largestError(shown.pictures[i], pictures[i]), 2) << i;
    }
    EXPECT_TRUE(shown.isEndless);
    EXPECT_NE(shown.comment.find("Program: test"), std::string::npos);
}

/// 15 fps are 6.67 hundredths of a second per frame: 7, 6, 7, 7, …
TEST_F(GifMovie, DelaysDoNotDrift)
{
    std::vector<core::ColorImage> pictures;
    for (int i = 0; i < 30; ++i) {
        pictures.push_back(moviePicture(32, 32, i % 5));
    }
    const Shown shown = written(pictures, 1000.0 / 15.0);
    int sum = 0;
    for (std::size_t i = 0; i < shown.delays.size(); ++i) {
        EXPECT_NEAR(sum, 100.0 / 15.0 * static_cast<double>(i), 0.5);
        sum += shown.delays[i];
    }
    EXPECT_EQ(sum, 200);
}

/// Viewers show frames shorter than 1/50 s for a tenth of a second.
TEST_F(GifMovie, LeavesOutPicturesThatComeTooFast)
{
    std::vector<core::ColorImage> pictures;
    for (int i = 0; i < 20; ++i) {
        pictures.push_back(moviePicture(32, 32, i % 7));
    }
    const Shown shown = written(pictures, 10.0);
    ASSERT_EQ(shown.pictures.size(), 11U);
    EXPECT_LE(largestError(shown.pictures.back(), pictures.back()), 2) << "the last one is shown";
    EXPECT_EQ(std::set<int>(shown.delays.begin(), shown.delays.end()), std::set<int>{2});
    EXPECT_LE(largestError(shown.pictures[1], pictures[2]), 2);
}

TEST_F(GifMovie, WritesOnlyWhatChanges)
{
    core::ColorImage first = moviePicture(100, 80, 0), second = first;
    test::forEachPixel({20, 10}, {40, 15},
                       [&](int x, int y) { second.rgb[static_cast<std::size_t>(3 * (y * 100 + x))] ^= 0x80; });
    const Shown shown = written({first, second, second, first}, 100.0);
    EXPECT_EQ(shown.areas, (std::vector<int>{8000, 100, 100}));
    EXPECT_EQ(shown.delays, (std::vector<int>{10, 20, 10}));
    EXPECT_LE(largestError(shown.pictures[2], first), 2);
}

TEST_F(GifMovie, LeavesNothingWithoutAnEnd)
{
    {
        auto movie = MovieWriter::create(path_, {64, 64}, {});
        ASSERT_TRUE(movie);
        EXPECT_TRUE(movie.value()->add(moviePicture(64, 64, 0), 40.0));
        EXPECT_TRUE(movie.value()->add(moviePicture(64, 64, 1), 40.0));
    }
    EXPECT_TRUE(fs::is_empty(folder_));
}

/// All gray values, and more colors than palette entries: grays stay within one step, colors within a small distance.
TEST(GifPalette, KeepsGraysAndColorsApart)
{
    core::ColorImage picture{256, 64, {}};
    test::forEachPixel(256, 64, [&](int x, int y) {
        const auto gray = static_cast<std::uint8_t>(x);
        const std::uint8_t mixed[3]{static_cast<std::uint8_t>(x / 2 + 2 * y), static_cast<std::uint8_t>(x), 250};
        const std::uint8_t plain[3]{gray, gray, gray};
        const std::uint8_t* color = y % 4 == 0 && mixed[2] - std::min(mixed[0], mixed[1]) > 20 ? mixed : plain;
        picture.rgb.insert(picture.rgb.end(), color, color + 3);
    });
    GifPalette palette(picture);
    EXPECT_LE(palette.colors().size(), 255U);
    for (int gray = 0; gray < 256; ++gray) {
        const auto value = static_cast<std::uint8_t>(gray);
        const auto shown = palette.colors()[palette.indexOf({value, value, value})];
        EXPECT_LE(std::abs(shown[0] - gray), 2) << gray;
        EXPECT_EQ(shown[0], shown[2]) << "grey stays grey";
    }
    for (std::size_t at = 0; at < picture.rgb.size(); at += 3) {
        const GifPalette::Color color{picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
        const auto shown = palette.colors()[palette.indexOf(color)];
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_NEAR(shown[i], color[i], 24) << at;
        }
    }
}

}   // namespace
}   // namespace angiopose::io
