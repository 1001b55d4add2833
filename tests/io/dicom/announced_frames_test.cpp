#include "io/angiogram_file.h"
#include "io/dicom/frame_time.h"
#include "tests/io/series/ct_phantom.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

constexpr int side = 16, framesThere = 3;

/// Three frames with one value each, and a header that declares `frames` as their number.
std::string runThatAnnounces(const std::string& frames, std::size_t bytesMissing = 0)
{
    std::vector<std::int16_t> pixels;
    for (int k = 0; k < framesThere; ++k) {
        pixels.insert(pixels.end(), side * side, static_cast<std::int16_t>(100 * (k + 1)));
    }
    test::DicomBytes data;
    data.text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.12.1");
    data.text(0x0008, 0x0060, "CS", "XA");
    data.number(0x0028, 0x0002, 1);
    data.text(0x0028, 0x0004, "CS", "MONOCHROME2");
    if (!frames.empty()) {
        data.text(0x0028, 0x0008, "IS", frames);
    }
    data.number(0x0028, 0x0010, side);
    data.number(0x0028, 0x0011, side);
    data.number(0x0028, 0x0100, 16);
    data.number(0x0028, 0x0101, 16);
    data.number(0x0028, 0x0102, 15);
    data.number(0x0028, 0x0103, 0);
    data.words(0x7fe0, 0x0010, pixels);
    const std::string content = std::string(128, '\0') + "DICM" + data.content();
    return content.substr(0, content.size() - bytesMissing);
}

/// Frame times from a header whose Frame Increment Pointer refers to the given element.
io::FrameTime frameTime(std::uint16_t pointedTo, const std::string& time, const std::string& vector)
{
    std::string bytes;
    const auto add = [&](std::uint16_t number) { bytes.append(reinterpret_cast<const char*>(&number), 2); };
    test::DicomBytes times;
    if (!time.empty()) {
        times.text(0x0018, 0x1063, "DS", time);
    }
    times.text(0x0018, 0x1065, "DS", vector);
    bytes = times.content();
    if (pointedTo != 0) {
        add(0x0028);
        add(0x0009);
        bytes += "AT";
        add(4);
        add(0x0018);
        add(pointedTo);
    }
    return io::frameTimeOf(io::readElements(bytes, io::DicomEncoding{}));
}

}   // namespace

TEST(AnnouncedFrames, ThoseThatAreThereAreLoadedAndItIsSaid)
{
    const test::TemporaryFolder folder;
    for (const char* announced : {"5", "2", ""}) {
        const auto run = io::readAngiogram(folder.write("run.dcm", runThatAnnounces(announced)));
        ASSERT_TRUE(run) << run.error().message;
        ASSERT_EQ(run.value().frameCount(), framesThere) << announced;
        EXPECT_EQ(run.value().frames[2].pixels.back(), 300.0F);
        const std::string said = *announced == '\0' ? "1" : announced;
        EXPECT_TRUE(
            test::mentions(run.value().warnings, "header declares " + said + " frames, but the file contains 3"));
    }
    const auto whole = io::readAngiogram(folder.write("run.dcm", runThatAnnounces("3")));
    ASSERT_TRUE(whole);
    EXPECT_FALSE(test::mentions(whole.value().warnings, "header declares "));
}

TEST(AnnouncedFrames, APartOfAFrameIsNone)
{
    const test::TemporaryFolder folder;
    const auto cut = io::readAngiogram(folder.write("run.dcm", runThatAnnounces("3", 40)));
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_EQ(cut.value().frameCount(), 2);
    EXPECT_TRUE(test::mentions(cut.value().warnings, "header declares 3 frames, but the file contains 2"));
    EXPECT_FALSE(test::mentions(cut.value().warnings, "the image is complete"));
    EXPECT_FALSE(io::readAngiogram(folder.write("run.dcm", runThatAnnounces("3", 2 * 2 * side * side + 40))));
}

TEST(FrameTime, FollowsTheFrameIncrementPointer)
{
    const io::FrameTime byVector = frameTime(0x1065, "33", "0\\66\\66\\900\\66");
    EXPECT_EQ(byVector.ms, 66.0);
    ASSERT_TRUE(byVector.contradiction);
    EXPECT_NE(
        byVector.contradiction->text().find("Frame Time 33.0 ms, Frame Time Vector 66.0 ms. The value used is 66.0 ms"),
        std::string::npos)
        << *byVector.contradiction;
    EXPECT_EQ(frameTime(0x1063, "33", "0\\66\\66").ms, 33.0);
    EXPECT_EQ(frameTime(0, "33", "0\\66\\66").ms, 33.0);
    EXPECT_EQ(frameTime(0x1063, "", "0\\66\\66").ms, 66.0);
    EXPECT_FALSE(frameTime(0x1065, "66", "0\\66\\66").contradiction);
}
