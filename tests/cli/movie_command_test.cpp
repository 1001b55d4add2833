#include "io/case/case_file.h"
#include "tests/cli/simulated_case.h"
#include "tests/support/temporary_folder.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using test::runCli;

/// Size, delays in 1/100 s and comment of a GIF.
struct GifReport {
    int width = 0, height = 0;
    std::vector<int> delays;
    std::string comment;
};

GifReport knownFrom(const std::string& path)
{
    GifReport reported;
    int error = 0;
    GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
    if (gif == nullptr || DGifSlurp(gif) != GIF_OK) {
        ADD_FAILURE() << "no GIF: " << path;
        return reported;
    }
    reported.width = gif->SWidth;
    reported.height = gif->SHeight;
    for (int k = 0; k < gif->ImageCount; ++k) {
        GraphicsControlBlock control{};
        DGifSavedExtensionToGCB(gif, k, &control);
        reported.delays.push_back(control.DelayTime);
        const SavedImage& image = gif->SavedImages[k];
        for (int i = 0; i < image.ExtensionBlockCount; ++i) {
            const ExtensionBlock& block = image.ExtensionBlocks[i];
            if (block.Function == COMMENT_EXT_FUNC_CODE || block.Function == CONTINUE_EXT_FUNC_CODE) {
                reported.comment.append(reinterpret_cast<const char*>(block.Bytes),
                                        static_cast<std::size_t>(block.ByteCount));
            }
        }
    }
    DGifCloseFile(gif, &error);
    return reported;
}

class CliMovie : public test::SimulatedCaseTest {
protected:
    test::ProgramOutcome movie(const std::string& name, std::vector<std::string> more)
    {
        std::vector<std::string> arguments{"movie", casePath_, "--output", folder_.file(name), "--width", "160"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments);
    }
    std::ptrdiff_t filesThere() const
    {
        return std::distance(fs::directory_iterator(fs::path(folder_.file("x")).parent_path()),
                             fs::directory_iterator());
    }
};

TEST_F(CliMovie, TurnsTheVesselsOnceInSixSeconds)
{
    const auto outcome = movie("turn.gif", {"--show", "turn", "--fps", "10"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    EXPECT_NE(outcome.output.find("60 frames, 6.00 s"), std::string::npos) << outcome.output;
    const GifReport reported = knownFrom(folder_.file("turn.gif"));
    EXPECT_EQ(reported.width, 160);
    EXPECT_EQ(reported.height, 160);
    EXPECT_EQ(reported.delays, std::vector<int>(60, 10));
    EXPECT_NE(reported.comment.find("Disclaimer: "), std::string::npos) << reported.comment;
}

TEST_F(CliMovie, ShowsHowARegistrationConverged)
{
    const auto outcome = movie("found.gif", {"--show", "convergence", "--fps", "20"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    const GifReport reported = knownFrom(folder_.file("found.gif"));
    ASSERT_GT(reported.delays.size(), 1U);
    EXPECT_EQ(reported.delays.back(), 150) << "rests on what was found";
}

TEST_F(CliMovie, WritesTheRunAsMp4)
{
    const auto outcome = movie("run.mp4", {"--fps", "4"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.messages;
    std::ifstream file(folder_.file("run.mp4"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(bytes.substr(4, 4), "ftyp");
    EXPECT_GT(bytes.size(), 3000U);
}

/// With --follow, the vessels have the pose of each frame, which changes their position and the texts.
TEST_F(CliMovie, FollowsTheVesselsThroughTheRun)
{
    const auto sizeOf = [this](const std::vector<std::string>& more) {
        const auto outcome = movie("run.gif", more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.messages;
        EXPECT_EQ(knownFrom(folder_.file("run.gif")).delays.size(), 3U);
        return fs::file_size(folder_.file("run.gif"));
    };
    const auto kept = sizeOf({"--frames", "3", "5", "--register", "--rigid"});
    EXPECT_NE(sizeOf({"--frames", "3", "5", "--register", "--follow", "--rigid"}), kept);
}

TEST_F(CliMovie, SaysWhatItCannotWrite)
{
    const auto other = movie("run.avi", {});
    EXPECT_EQ(other.exitCode, 3);
    EXPECT_NE(other.messages.find(".mp4 or .gif"), std::string::npos) << other.messages;
    EXPECT_EQ(movie("run.gif", {"--frames", "3", "99"}).exitCode, 3);
    EXPECT_EQ(movie("run.gif", {"--show", "dance"}).exitCode, 2);
    EXPECT_EQ(filesThere(), 1) << "nothing but the case";
}

TEST_F(CliMovie, LeavesNothingWhereItIsStopped)
{
    const auto outcome = runCli(
        {"movie", casePath_, "--output", folder_.file("turn.mp4"), "--show", "turn", "--fps", "100", "--width", "1600"},
        1.5);
    EXPECT_EQ(outcome.exitCode, 130) << outcome.messages;
    EXPECT_EQ(filesThere(), 1);
}

}   // namespace
