#include "io/image_file.h"

#include "io/angiogram_file.h"
#include "io/messages/messages.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace angiopose;

TEST(WritePng, IsReadBackPixelByPixel)
{
    const test::TemporaryFolder folder;
    core::ColorImage image{31, 17, {}};
    for (int i = 0; i < 31 * 17; ++i) {
        const auto level = static_cast<std::uint8_t>(i * 7);
        image.rgb.insert(image.rgb.end(), {level, level, level});
    }
    ASSERT_TRUE(io::writePng(image, folder.file("grey.png"), {{"Software", "AngioPose"}, {"Title", "Größe"}}));
    const auto read = io::readAngiogram(folder.file("grey.png"));
    ASSERT_TRUE(read) << read.error().message;
    for (std::size_t i = 0; i < 31 * 17; ++i) {
        ASSERT_EQ(read.value().frames[0].pixels[i], static_cast<float>(image.rgb[3 * i]));
    }
    const std::string content = test::readText(folder.file("grey.png"));
    EXPECT_NE(content.find("iTXtSoftware"), std::string::npos);
    EXPECT_NE(content.find("Größe"), std::string::npos);
}

TEST(WritePng, TurnsColorIntoLuminanceWithAWarning)
{
    const test::TemporaryFolder folder;
    core::ColorImage red{8, 8, {}};
    for (int i = 0; i < 64; ++i) {
        red.rgb.insert(red.rgb.end(), {200, 0, 0});
    }
    ASSERT_TRUE(io::writePng(red, folder.file("red.png")));
    const auto read = io::readAngiogram(folder.file("red.png"));
    ASSERT_TRUE(read);
    EXPECT_NEAR(read.value().frames[0].at(3, 3), 0.299 * 200, 0.01);
    EXPECT_EQ(read.value().warnings.front(), io::messages::colorToGray());
}

TEST(WritePng, RefusesAnEmptyPicture)
{
    const test::TemporaryFolder folder;
    EXPECT_FALSE(io::writePng(core::ColorImage{}, folder.file("none.png")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("none.png")));
}
