#include "io/subtraction_file.h"

#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <cstring>
#include <fstream>

using namespace angiopose;

namespace {

std::string littleEndian(std::uint32_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
    }
    return text;
}

/// One element in explicit little endian; sequences and such have the long form.
std::string element(std::uint32_t tag, const std::string& vr, std::string value)
{
    if (value.size() % 2 == 1) {
        value.push_back(' ');
    }
    const auto size = static_cast<std::uint32_t>(value.size());
    const bool isLong = vr == "SQ" || vr == "OW";
    return littleEndian(tag >> 16U, 2) + littleEndian(tag & 0xFFFFU, 2) + vr +
           (isLong ? littleEndian(0, 2) + littleEndian(size, 4) : littleEndian(size, 2)) + value;
}

std::string sequenceItem(const std::string& content)
{
    return littleEndian(0xFFFE, 2) + littleEndian(0xE000, 2) +
           littleEndian(static_cast<std::uint32_t>(content.size()), 4) + content;
}

std::string single(float value)
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return littleEndian(bits, 4);
}

core::Result<core::SubtractionPlan> planOf(const std::string& elements)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("run.dcm");
    const std::string meta = element(0x00020010, "UI", std::string("1.2.840.10008.1.2.1") + '\0');
    std::ofstream(path, std::ios::binary)
        << std::string(128, '\0') << "DICM"
        << element(0x00020000, "UL", littleEndian(static_cast<std::uint32_t>(meta.size()), 4)) << meta << elements;
    return io::readSubtractionPlan(path);
}

TEST(ReadSubtractionPlan, TakesFramesAndShiftFromTheMaskModule)
{
    const std::string none = sequenceItem(element(0x00286101, "CS", "NONE"));
    const std::string mask = sequenceItem(element(0x00286101, "CS", "AVG_SUB") +
                                          element(0x00286110, "US", littleEndian(2, 2) + littleEndian(4, 2)) +
                                          element(0x00286114, "FL", single(-0.5F) + single(1.25F)));
    const auto plan = planOf(element(0x00281040, "CS", "LOG") + element(0x00286100, "SQ", none + mask));
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan.value().maskFrames, (std::vector<int>{1, 3})) << "counted from 0";
    ASSERT_TRUE(plan.value().maskShiftPx);
    EXPECT_EQ(*plan.value().maskShiftPx, Eigen::Vector2d(1.25, -0.5)) << "stored as down, right";
    EXPECT_EQ(plan.value().relation, core::PixelRelation::Logarithmic);
}

TEST(ReadSubtractionPlan, TakesIntervalsFromTheMaskModule)
{
    const std::string tid =
        sequenceItem(element(0x00286101, "CS", "TID") + element(0x00286120, "SS", littleEndian(3, 2)));
    EXPECT_EQ(planOf(element(0x00286100, "SQ", tid)).value().interval, (core::MaskInterval{3, std::nullopt}));
    const std::string reversed = sequenceItem(element(0x00286101, "CS", "REV_TID") +
                                              element(0x00286102, "US", littleEndian(6, 2) + littleEndian(9, 2)) +
                                              element(0x00286120, "SS", littleEndian(0xFFFF, 2)));
    EXPECT_EQ(planOf(element(0x00286100, "SQ", reversed)).value().interval, (core::MaskInterval{-1, 5}));
}

TEST(ReadSubtractionPlan, LeavesOpenWhatTheFileDoesNotSay)
{
    const auto plan = planOf(element(0x00281040, "CS", "LIN"));
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan.value(), core::SubtractionPlan{});
}

TEST(ReadSubtractionPlan, MissingFilesAreNamed)
{
    const auto plan = io::readSubtractionPlan("/no/such/run.dcm");
    ASSERT_FALSE(plan);
    EXPECT_NE(plan.error().message.text().find("/no/such/run.dcm"), std::string::npos);
}

}   // namespace
