#include "io/angiogram_file.h"
#include "io/messages/messages.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <vector>

using namespace angiopose;

namespace {

const std::string phantomRun = "coronary-phantom-xa/views-A/IM1.dcm";   // 14 frames of lossless JPEG

/// The run with the headers of the JPEG streams of some frames overwritten.
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

const std::string colorPicture = "exotic-dicom/pydicom/SC_rgb_jpeg_dcmtk.dcm";   // one frame of lossy JPEG

std::string littleEndian(std::size_t value)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) {
        bytes += static_cast<char>(value >> shift & 0xff);
    }
    return bytes;
}

/// The JPEG stream of the image, with its padding.
std::string streamOf(const std::string& content)
{
    const std::size_t start = content.rfind("\xff\xd8\xff");
    return content.substr(start, content.rfind("\xff\xd9") + 2 - start);
}

/// The stream as a faulty vendor encoder leaves it: some coded data is missing, the end marker is present.
std::string withAHole(std::string stream)
{
    const std::size_t scan = stream.find("\xff\xda");
    stream.erase(scan + 3 * (stream.size() - scan) / 4, 40);
    return stream;
}

/// A run of these streams with the header of the image.
std::string runOf(std::string content, const std::vector<std::string>& streams)
{
    content.resize(content.rfind("\xff\xd8\xff") - 8);
    for (std::string stream : streams) {
        stream.resize(stream.size() + stream.size() % 2);
        content += std::string("\xfe\xff\x00\xe0", 4) + littleEndian(stream.size()) + stream;
    }
    content += std::string("\xfe\xff\xdd\xe0\0\0\0\0", 8);
    const std::string count = std::to_string(streams.size()) + " ";
    return content.insert(content.find(std::string("\x28\0\x10\0US", 6)),
                          std::string("\x28\0\x08\0IS\x02\0", 8) + count);
}

}   // namespace

TEST(LostFrames, DamagedInPartShowWhatCanBeDecoded)
{
    ANGIOPOSE_NEEDS_DATA(colorPicture);
    const test::TemporaryFolder folder;
    const std::string picture = test::readText(test::dataFile(colorPicture));
    const std::string sound = streamOf(picture);
    const auto read = io::readAngiogram(folder.write("run.dcm", runOf(picture, {sound, withAHole(sound), sound})));
    ASSERT_TRUE(read) << read.error().message;
    const core::Angiogram& run = read.value();
    ASSERT_EQ(run.frameCount(), 3);
    EXPECT_EQ(run.frames[0].pixels, run.frames[2].pixels);
    EXPECT_NE(run.frames[0].pixels, run.frames[1].pixels);
    const auto quarter = static_cast<std::ptrdiff_t>(run.frames[0].pixels.size() / 4);
    EXPECT_TRUE(
        std::equal(run.frames[0].pixels.begin(), run.frames[0].pixels.begin() + quarter, run.frames[1].pixels.begin()));
    const auto warning = std::ranges::find_if(
        run.warnings, [](const core::Message& found) { return found.is(io::messages::dicomFramesFlawed); });
    ASSERT_NE(warning, run.warnings.end());
    EXPECT_EQ(std::get<std::vector<std::string>>(warning->arguments()[0]), std::vector<std::string>{"2"});
}

TEST(LostFrames, APictureDamagedInPartIsShownAndSaidToBe)
{
    ANGIOPOSE_NEEDS_DATA(colorPicture);
    const test::TemporaryFolder folder;
    const std::string sound = streamOf(test::readText(test::dataFile(colorPicture)));
    const auto isFlawed = [](const core::Message& found) { return found.is(io::messages::imageFlawed); };
    const auto whole = io::readAngiogram(folder.write("whole.jpg", sound));
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_TRUE(std::ranges::none_of(whole.value().warnings, isFlawed));
    const auto damaged = io::readAngiogram(folder.write("damaged.jpg", withAHole(sound)));
    ASSERT_TRUE(damaged) << damaged.error().message;
    EXPECT_TRUE(std::ranges::any_of(damaged.value().warnings, isFlawed));
}

TEST(LostFrames, AreNamedAndEmptyWhileTheOthersAreWhole)
{
    ANGIOPOSE_NEEDS_DATA(phantomRun);
    const test::TemporaryFolder folder;
    const auto whole = io::readAngiogram(test::dataFile(phantomRun).string());
    ASSERT_TRUE(whole) << whole.error().message;
    const int peak = whole.value().suggestedFrame;
    const auto damaged = io::readAngiogram(
        folder.write("run.dcm", withoutFrames(test::readText(test::dataFile(phantomRun)), {0, peak})));
    ASSERT_TRUE(damaged) << damaged.error().message;
    const core::Angiogram& run = damaged.value();
    ASSERT_EQ(run.frameCount(), 14);
    for (int k = 0; k < run.frameCount(); ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (k == 0 || k == peak) {
            EXPECT_TRUE(isFlat(run.frames[at])) << k;
        } else {
            EXPECT_EQ(run.frames[at].pixels, whole.value().frames[at].pixels) << k;
        }
    }
    EXPECT_NE(run.suggestedFrame, peak);
    const auto warning = std::ranges::find_if(
        run.warnings, [](const core::Message& found) { return found.is(io::messages::dicomFramesLost); });
    ASSERT_NE(warning, run.warnings.end());
    EXPECT_EQ(std::get<std::vector<std::string>>(warning->arguments()[0]),
              (std::vector<std::string>{"1", std::to_string(peak + 1)}));
}

TEST(LostFrames, ARunWithoutAnyOtherIsRefused)
{
    ANGIOPOSE_NEEDS_DATA(phantomRun);
    const test::TemporaryFolder folder;
    const auto run =
        io::readAngiogram(folder.write("run.dcm", withoutFrames(test::readText(test::dataFile(phantomRun)),
                                                                {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13})));
    ASSERT_FALSE(run);
    EXPECT_NE(run.error().message.text().find("frame 1 cannot be decoded"), std::string::npos);
}
