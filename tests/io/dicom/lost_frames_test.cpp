#include "io/angiogram_file.h"
#include "io/messages/says.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <vector>

using namespace angiopose;

namespace {

const std::string phantomRun = "coronary-phantom-xa/views-A/IM1.dcm";   // 14 frames of lossless JPEG

/// The run with the header of some frames' JPEG streams overwritten.
std::string withoutFrames(std::string content, const std::vector<int>& lost)
{
    const std::string_view start("\xff\xd8\xff\xc4", 4);
    int frame = 0;
    for (std::size_t at = content.find(start); at != std::string::npos; at = content.find(start, at + 1)) {
        if (std::ranges::find(lost, frame++) != lost.end()) {
            content.replace(at + 2, 12, 12, '\0');
        }
    }
    EXPECT_EQ(frame, 14);
    return content;
}

bool isFlat(const core::ImageF& frame)
{
    return std::ranges::all_of(frame.pixels, [&](float value) { return value == frame.pixels.front(); });
}

}   // namespace

TEST(LostFrames, AreNamedAndEmptyWhileTheOthersAreWhole)
{
    ANGIOPOSE_NEEDS_DATA(phantomRun);
    const test::TemporaryFolder folder;
    const auto whole = io::readAngiogram(test::dataFile(phantomRun).string());
    ASSERT_TRUE(whole) << whole.error().message;
    const int fullest = whole.value().suggestedFrame;
    const auto damaged = io::readAngiogram(
        folder.write("run.dcm", withoutFrames(test::readText(test::dataFile(phantomRun)), {0, fullest})));
    ASSERT_TRUE(damaged) << damaged.error().message;
    const core::Angiogram& run = damaged.value();
    ASSERT_EQ(run.frameCount(), 14);
    for (int k = 0; k < run.frameCount(); ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (k == 0 || k == fullest) {
            EXPECT_TRUE(isFlat(run.frames[at])) << k;
        } else {
            EXPECT_EQ(run.frames[at].pixels, whole.value().frames[at].pixels) << k;
        }
    }
    EXPECT_NE(run.suggestedFrame, fullest);
    const auto warning = std::ranges::find_if(
        run.warnings, [](const core::Message& found) { return found.is(io::says::dicomFramesLost); });
    ASSERT_NE(warning, run.warnings.end());
    EXPECT_EQ(std::get<std::vector<std::string>>(warning->arguments()[0]),
              (std::vector<std::string>{"0", std::to_string(fullest)}));
}

TEST(LostFrames, ARunWithoutAnyOtherIsRefused)
{
    ANGIOPOSE_NEEDS_DATA(phantomRun);
    const test::TemporaryFolder folder;
    const auto run =
        io::readAngiogram(folder.write("run.dcm", withoutFrames(test::readText(test::dataFile(phantomRun)),
                                                                {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13})));
    ASSERT_FALSE(run);
    EXPECT_NE(run.error().message.text().find("frame 0 cannot be decoded"), std::string::npos);
}
