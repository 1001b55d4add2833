#include "io/dicom/shutter_tags.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace angiopose;

namespace {

struct ReadShutter {
    core::Mask2d field;
    core::Messages warnings;
};

using Elements = std::initializer_list<std::pair<io::DicomTag, std::string>>;

std::string littleEndian(std::size_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
    return text;
}

std::string bytesOf(Elements elements)
{
    std::string bytes;
    for (auto [tag, value] : elements) {
        value += value.size() % 2 == 1 ? " " : "";
        bytes += littleEndian(tag >> 16U, 2) + littleEndian(tag & 0xffffU, 2) + (tag == 0x00181600 ? "CS" : "IS") +
                 littleEndian(value.size(), 2) + value;
    }
    return bytes;
}

std::string sequence(io::DicomTag tag, const std::vector<std::string>& items)
{
    std::string content;
    for (const std::string& item : items) {
        content += littleEndian(0xfffe, 2) + littleEndian(0xe000, 2) + littleEndian(item.size(), 4) + item;
    }
    return littleEndian(tag >> 16U, 2) + littleEndian(tag & 0xffffU, 2) + "SQ" + littleEndian(0, 2) +
           littleEndian(content.size(), 4) + content;
}

ReadShutter shutterIn(const std::string& bytes)
{
    ReadShutter read;
    read.field = io::shutterMask(io::readElements(bytes, io::DicomEncoding{}), 60, 40, read.warnings);
    return read;
}

/// Shutter of an image of 60 columns and 40 rows with these elements, in ascending order.
ReadShutter shutterMask(Elements elements)
{
    return shutterIn(bytesOf(elements));
}

/// First and last open pixel of a row or column, counted from 0.
std::pair<int, int> openInRow(const core::Mask2d& field, int row)
{
    int first = -1, last = -1;
    for (int x = 0; x < field.width; ++x) {
        if (field.at(x, row) != 0) {
            first = first < 0 ? x : first;
            last = x;
        }
    }
    return {first, last};
}

using Span = std::pair<int, int>;

TEST(ShutterTags, ARectangleKeepsItsEdgesThatCountFromOne)
{
    const auto read = shutterMask(
        {{0x00181600, "RECTANGULAR"}, {0x00181602, "11"}, {0x00181604, "50"}, {0x00181606, "6"}, {0x00181608, "35"}});
    EXPECT_TRUE(read.warnings.empty());
    ASSERT_EQ(read.field.width, 60);
    ASSERT_EQ(read.field.height, 40);
    EXPECT_EQ(openInRow(read.field, 5), Span(10, 49));
    EXPECT_EQ(openInRow(read.field, 34), Span(10, 49));
    EXPECT_EQ(openInRow(read.field, 4), Span(-1, -1));
    EXPECT_EQ(openInRow(read.field, 35), Span(-1, -1));
}

TEST(ShutterTags, ACircleIsCenteredByRowAndColumn)
{
    const auto read = shutterMask({{0x00181600, "CIRCULAR"}, {0x00181610, "21\\31"}, {0x00181612, "10"}});
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(openInRow(read.field, 20), Span(20, 40));
    EXPECT_EQ(openInRow(read.field, 10), Span(30, 30));
    EXPECT_EQ(openInRow(read.field, 26), Span(22, 38));
    EXPECT_EQ(openInRow(read.field, 31), Span(-1, -1));
}

TEST(ShutterTags, APolygonHasVerticesByRowAndColumn)
{
    const auto read = shutterMask({{0x00181600, "POLYGONAL"}, {0x00181620, "1\\1\\1\\41\\31\\41\\31\\31"}});
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(openInRow(read.field, 0), Span(0, 40));
    EXPECT_EQ(openInRow(read.field, 10), Span(10, 40));
    EXPECT_EQ(openInRow(read.field, 30), Span(30, 40)) << "the lower edge too";
    EXPECT_EQ(openInRow(read.field, 31), Span(-1, -1));
}

TEST(ShutterTags, OfSeveralShapesWhatIsInsideAllIsOpen)
{
    const auto read = shutterMask({{0x00181600, "RECTANGULAR\\CIRCULAR"},
                                   {0x00181602, "31"},
                                   {0x00181604, "60"},
                                   {0x00181606, "1"},
                                   {0x00181608, "40"},
                                   {0x00181610, "21\\31"},
                                   {0x00181612, "10"}});
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(openInRow(read.field, 20), Span(30, 40));
}

TEST(ShutterTags, AShutterThatHidesNothingIsNone)
{
    EXPECT_TRUE(shutterMask({}).field.isEmpty());
    const auto open = shutterMask(
        {{0x00181600, "RECTANGULAR"}, {0x00181602, "0"}, {0x00181604, "61"}, {0x00181606, "1"}, {0x00181608, "40"}});
    EXPECT_TRUE(open.field.isEmpty());
    EXPECT_TRUE(open.warnings.empty());
}

TEST(ShutterTags, WhatMakesNoSenseIsIgnoredAndSaid)
{
    const auto expectIgnored = [](const ReadShutter& read, const std::string& value) {
        EXPECT_TRUE(read.field.isEmpty());
        ASSERT_EQ(read.warnings.size(), 1U);
        EXPECT_EQ(read.warnings.front().id(), "dicom.shutter-unusable");
        EXPECT_NE(read.warnings.front().text().find(value), std::string::npos) << read.warnings.front();
    };
    expectIgnored(shutterMask({{0x00181600, "RECTANGULAR"},   // edges the wrong way round
                               {0x00181602, "50"},
                               {0x00181604, "11"},
                               {0x00181606, "6"},
                               {0x00181608, "35"}}),
                  "50, 11, 6, 35");
    expectIgnored(shutterMask({{0x00181600, "RECTANGULAR"},   // beside the image
                               {0x00181602, "100"},
                               {0x00181604, "160"},
                               {0x00181606, "6"},
                               {0x00181608, "35"}}),
                  "100, 160");
    expectIgnored(shutterMask({{0x00181600, "RECTANGULAR"}, {0x00181602, "11"}, {0x00181604, "50"}}), "11, 50");
    expectIgnored(shutterMask({{0x00181600, "CIRCULAR"}, {0x00181610, "21\\31"}, {0x00181612, "0"}}), "21\\31");
    expectIgnored(shutterMask({{0x00181600, "POLYGONAL"}, {0x00181620, "1\\1\\1\\41\\31"}}), "1\\1\\1\\41\\31");
    expectIgnored(shutterMask({{0x00181600, "POLYGONAL"}}), "POLYGONAL");
}

TEST(ShutterTags, AShapeThatMakesNoSenseLeavesTheOthers)
{
    const auto read = shutterMask({{0x00181600, "RECTANGULAR\\CIRCULAR"},
                                   {0x00181602, "0"},
                                   {0x00181604, "0"},
                                   {0x00181606, "0"},
                                   {0x00181608, "0"},
                                   {0x00181610, "21\\31"},
                                   {0x00181612, "10"}});
    EXPECT_EQ(read.warnings.size(), 1U);
    EXPECT_EQ(openInRow(read.field, 20), Span(20, 40));
}

TEST(ShutterTags, WhatTheShuttersOfAllFramesLeaveOpenIsOpen)
{
    const auto frame = [](const char* left, const char* right) {
        return sequence(0x00189472, {bytesOf({{0x00181600, "RECTANGULAR"},
                                              {0x00181602, left},
                                              {0x00181604, right},
                                              {0x00181606, "1"},
                                              {0x00181608, "40"}})});
    };
    const auto read = shutterIn(sequence(0x52009230, {frame("11", "60"), frame("11", "60"), frame("1", "50")}));
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(openInRow(read.field, 20), Span(10, 49));
}

}   // namespace
