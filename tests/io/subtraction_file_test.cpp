#include "io/subtraction_file.h"

#include "io/angiogram_file.h"
#include "io/opening/assemble_case.h"
#include "io/opening/read_inputs.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
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

/// Encodes one element in explicit little endian; sequences and similar VRs use the long form.
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

core::Result<core::RunProcessing> treatmentOf(const std::string& elements)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("run.dcm");
    const std::string meta = element(0x00020010, "UI", std::string("1.2.840.10008.1.2.1") + '\0');
    std::ofstream(path, std::ios::binary)
        << std::string(128, '\0') << "DICM"
        << element(0x00020000, "UL", littleEndian(static_cast<std::uint32_t>(meta.size()), 4)) << meta << elements;
    return io::readRunProcessing(path);
}

core::Result<core::SubtractionPlan> planOf(const std::string& elements)
{
    const auto processing = treatmentOf(elements);
    return processing ? core::Result<core::SubtractionPlan>(processing.value().plan) : processing.error();
}

TEST(ReadTreatment, SubtractsWhereTheHeaderNamesAMask)
{
    const std::string mask =
        element(0x00286100, "SQ",
                sequenceItem(element(0x00286101, "CS", "AVG_SUB") + element(0x00286110, "US", littleEndian(1, 2))));
    const std::string tid = element(0x00286100, "SQ", sequenceItem(element(0x00286101, "CS", "TID")));
    EXPECT_TRUE(treatmentOf(mask).value().isSubtracted);
    EXPECT_TRUE(treatmentOf(tid).value().isSubtracted);
    EXPECT_TRUE(treatmentOf(element(0x00281090, "CS", "SUB") + mask).value().isSubtracted);
    EXPECT_FALSE(treatmentOf(element(0x00281090, "CS", "NAT") + mask).value().isSubtracted);
    EXPECT_FALSE(treatmentOf(element(0x00281090, "CS", "SUB")).value().isSubtracted) << "there is no mask";
}

/// Writes a run of three frames whose header names frame `number` as mask.
std::string runWithMask(const test::TemporaryFolder& folder, const std::string& number)
{
    core::Angiogram run;
    for (int k = 0; k < 3; ++k) {
        run.frames.emplace_back(32, 32, 1000.0F);
        run.frames.back().at(16, 16) = 500.0F;   // a bone
        run.frames.back().at(8, 8) = k == 0 ? 1000.0F : 600.0F;
    }
    const std::string path = folder.file("run.dcm");
    EXPECT_TRUE(io::writeAngiogram(run, path));
    std::string content = test::readText(path);
    const std::size_t pixels = content.find(std::string("\xe0\x7f\x10\x00", 4) + "OW");
    EXPECT_NE(pixels, std::string::npos);
    content.insert(pixels,
                   element(0x00286100, "SQ",
                           sequenceItem(element(0x00286101, "CS", "AVG_SUB") + element(0x00286110, "US", number))));
    return folder.write("masked.dcm", content);
}

TEST(ReadTreatment, ARunIsOpenedSubtractedWhereItNamesItsMask)
{
    const test::TemporaryFolder folder;
    const auto inputs = io::readInputs({runWithMask(folder, littleEndian(1, 2))}, {}, {});
    ASSERT_TRUE(inputs) << inputs.error().message;
    const core::View view = io::assembleCase({}, inputs.value()).shown();
    EXPECT_TRUE(view.processing.isSubtracted);
    ASSERT_TRUE(view.storedRun);
    EXPECT_NEAR(view.angiogram->frames[1].at(16, 16), view.angiogram->frames[1].at(20, 20), 20.0) << "the bone is gone";
    EXPECT_LT(view.angiogram->frames[1].at(8, 8), view.angiogram->frames[1].at(20, 20) - 200.0F);
    EXPECT_LT(view.storedRun->frames[1].at(16, 16), 600.0F);
}

TEST(ReadTreatment, AMaskThatIsNotThereLeavesTheRunNativeAndIsSaid)
{
    const test::TemporaryFolder folder;
    const auto inputs = io::readInputs({runWithMask(folder, littleEndian(9, 2))}, {}, {});
    ASSERT_TRUE(inputs) << inputs.error().message;
    EXPECT_FALSE(io::assembleCase({}, inputs.value()).shown().processing.isSubtracted);
    EXPECT_TRUE(std::ranges::any_of(inputs.value().warnings, [](const core::Message& warning) {
        return warning.text().find("Mask frame 9 does not exist") != std::string::npos;
    }));
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
