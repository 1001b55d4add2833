#include "io/dicom/heart_beats.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <utility>

using namespace angiopose;

namespace {

using Frames = std::vector<int>;

/// A data set with these elements in ascending order, as text.
io::DicomDataset beatHeader(std::initializer_list<std::pair<io::DicomTag, std::string>> elements)
{
    std::string bytes;
    const auto add = [&](std::size_t number) {
        bytes += static_cast<char>(number & 0xff);
        bytes += static_cast<char>(number >> 8 & 0xff);
    };
    for (auto [tag, value] : elements) {
        value += value.size() % 2 == 0 ? "" : " ";
        add(tag >> 16);
        add(tag);
        bytes += "DS";
        add(value.size());
        bytes += value;
    }
    return io::readElements(bytes, io::DicomEncoding{});
}

}   // namespace

TEST(HeartBeats, PointersCountFromOne)
{
    const auto header = beatHeader({{0x00286040, "9\\2\\2\\11\\0"}});
    EXPECT_EQ(io::rWaveFramesOf(header, 10, 66.0), (Frames{1, 8}));
}

TEST(HeartBeats, TimesBelongToTheNearestFrame)
{
    const auto header = beatHeader({{0x00186060, "100\\549.9\\5000"}});
    EXPECT_EQ(io::rWaveFramesOf(header, 10, 100.0), (Frames{1, 5}));
}

TEST(HeartBeats, TimesFollowFramesOfUnequalLength)
{
    const auto header = beatHeader({{0x00181065, "0\\100\\400\\100"}, {0x00186060, "480"}});
    EXPECT_EQ(io::rWaveFramesOf(header, 4, 100.0), (Frames{2}));
}

TEST(HeartBeats, TimesSayNothingWhereFramesHaveNone)
{
    const auto header = beatHeader({{0x00186060, "100\\500"}});
    EXPECT_EQ(io::rWaveFramesOf(header, 10, 0.0), Frames{});
}

TEST(HeartBeats, AHeaderWithoutThemHasNone)
{
    EXPECT_EQ(io::rWaveFramesOf(beatHeader({{0x00181063, "66"}}), 10, 66.0), Frames{});
}
