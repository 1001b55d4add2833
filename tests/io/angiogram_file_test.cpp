#include "io/angiogram_file.h"

#include "tests/io/phantom_view.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <limits>

using namespace angiopose;

TEST(ReadAngiogram, ReadsEveryPhantomView)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM1.dcm");
    struct Expected {
        int frames;
        double primaryDeg, secondaryDeg, sidMm;
    };
    const Expected expected[] = {
        {14, 31.3, 0.1, 860}, {12, -27.3, -0.1, 865}, {12, -0.8, -23.2, 891}, {10, 0.1, 28.7, 907}};
    for (int view = 1; view <= 4; ++view) {
        const core::Angiogram angiogram = test::phantomView(view);
        const Expected& wanted = expected[view - 1];
        EXPECT_EQ(angiogram.frameCount(), wanted.frames);
        EXPECT_EQ(angiogram.width(), 512);
        EXPECT_EQ(angiogram.height(), 512);
        EXPECT_EQ(angiogram.cArm.primaryAngleDeg.value, wanted.primaryDeg);
        EXPECT_EQ(angiogram.cArm.secondaryAngleDeg.value, wanted.secondaryDeg);
        EXPECT_EQ(angiogram.cArm.sourceToDetectorMm.value, wanted.sidMm);
        EXPECT_EQ(angiogram.cArm.sourceToIsocenterMm.value, 720.0);
        EXPECT_EQ(angiogram.cArm.sourceToDetectorMm.origin, core::Origin::Header);
        EXPECT_EQ(angiogram.cArm.sourceToDetectorMm.basis, "(0018,1110) Distance Source to Detector");
        EXPECT_EQ(angiogram.polarity, core::Polarity::VesselsDark);
        EXPECT_NEAR(angiogram.frameTimeMs, 66.6667, 1e-9);
        EXPECT_EQ(angiogram.identity.modality, "XA");
        EXPECT_EQ(angiogram.identity.patientName, "fantom^as");
        EXPECT_EQ(angiogram.identity.birthDate, "1970-04-13");
        EXPECT_EQ(angiogram.identity.studyTime, "14:49");
    }
}

TEST(ReadAngiogram, NeverPassesADerivedSpacingForTheHeaders)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM1.dcm");
    const core::Angiogram angiogram = test::phantomView(1);   // (0018,1164) is absent
    EXPECT_EQ(angiogram.cArm.columnSpacingMm.origin, core::Origin::Derived);
    EXPECT_NEAR(*angiogram.cArm.columnSpacingMm.value, 0.390625, 1e-12);
    EXPECT_NE(angiogram.cArm.columnSpacingMm.basis.find("field of view"), std::string::npos);
    ASSERT_EQ(angiogram.warnings.size(), 1u);
    EXPECT_NE(angiogram.warnings.front().text().find("(0018,1164)"), std::string::npos);
}

namespace {

core::Angiogram smallRun()
{
    core::Angiogram angiogram;
    for (int k = 0; k < 3; ++k) {
        core::ImageF frame(20, 16);
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            frame.pixels[i] = static_cast<float>((i * 37 + static_cast<std::size_t>(k) * 1000) % 4096);
        }
        angiogram.frames.push_back(std::move(frame));
    }
    angiogram.frameTimeMs = 66.6;
    angiogram.cArm.sourceToDetectorMm = {1063.25, core::Origin::Header, ""};
    angiogram.cArm.sourceToIsocenterMm = {765.5, core::Origin::Header, ""};
    angiogram.cArm.rowSpacingMm = {0.308, core::Origin::Header, ""};
    angiogram.cArm.columnSpacingMm = {0.309, core::Origin::Header, ""};
    angiogram.cArm.primaryAngleDeg = {-31.4, core::Origin::Header, ""};
    angiogram.cArm.secondaryAngleDeg = {12.7, core::Origin::Header, ""};
    angiogram.identity.patientName = "Müller^Ünal";
    angiogram.identity.studyDate = "2024-02-29";
    return angiogram;
}

}   // namespace

TEST(WriteAngiogram, WritesWhatARoomTells)
{
    const test::TemporaryFolder folder;
    core::Angiogram original = smallRun();
    original.cArm.primaryAngleDeg.value = 88.0;   // lateral
    original.cArm.mirrored = {true, core::Origin::Header, ""};
    original.cArm.sourceToIsocenterMm.value = 750.0;
    original.cArm.sourceToObjectMm = {683.0, core::Origin::Header, ""};
    original.gantry.table = core::TablePosition{{-4.5, 7.8, 123.4}, core::TablePosition::Tags::Siemens};
    original.gantry.tableMoves = true;
    original.gantry.biplane = core::BiplaneTime{'B', "20240229", 36900.0};
    ASSERT_TRUE(io::writeAngiogram(original, folder.file("run.dcm")));
    const auto copy = io::readAngiogram(folder.file("run.dcm"));
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().cArm.mirrored.value, true);
    EXPECT_EQ(copy.value().cArm.sourceToIsocenterMm.value, 750.0);
    EXPECT_NE(copy.value().cArm.sourceToIsocenterMm.basis.find("(0021,1017)"), std::string::npos);
    EXPECT_EQ(copy.value().cArm.sourceToObjectMm.value, 683.0);
    const core::GantryHeader& gantry = copy.value().gantry;
    ASSERT_TRUE(gantry.table);
    EXPECT_EQ(gantry.table->tags, core::TablePosition::Tags::Siemens);
    EXPECT_LT((gantry.table->isocenterInPatientMm - Eigen::Vector3d(-4.5, 7.8, 123.4)).norm(), 1e-9);
    EXPECT_TRUE(gantry.tableMoves);
    ASSERT_TRUE(gantry.biplane);
    EXPECT_EQ(gantry.biplane->plane, 'B');
    EXPECT_EQ(gantry.biplane->timeS, 36900.0);
}

TEST(WriteAngiogram, KeepsAnAssumedIsocenterAssumed)
{
    const test::TemporaryFolder folder;
    core::Angiogram original = smallRun();
    original.cArm.sourceToIsocenterMm = {};
    original.cArm.sourceToObjectMm = {683.0, core::Origin::Header, ""};
    assumeIsocenter(original.cArm);
    ASSERT_TRUE(io::writeAngiogram(original, folder.file("run.dcm")));
    const auto copy = io::readAngiogram(folder.file("run.dcm"));
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy.value().cArm.sourceToIsocenterMm.value, 683.0);
    EXPECT_EQ(copy.value().cArm.sourceToIsocenterMm.origin, core::Origin::Assumed);
}

TEST(WriteAngiogram, RoundTripsPixelsAndGeometry)
{
    const test::TemporaryFolder folder;
    core::Angiogram original = smallRun();
    original.cArm.principalPointPx = {Eigen::Vector2d(9.25, 8.5), core::Origin::Derived, ""};
    original.cArm.mirrored = {true, core::Origin::User, ""};
    original.cArm.sourceToObjectMm = {683.0, core::Origin::Header, ""};
    original.gantry.patientPosition = core::PatientPosition::FFS;
    original.gantry.table = core::TablePosition{{12.5, -7.25, 130.0}, core::TablePosition::Tags::Standard};
    original.polarity = core::Polarity::VesselsBright;
    original.rWaveFrames = {0, 2};
    const auto written = io::writeAngiogram(original, folder.file("run.dcm"));
    ASSERT_TRUE(written) << written.error().message;
    const auto read = io::readAngiogram(folder.file("run.dcm"));
    ASSERT_TRUE(read) << read.error().message;
    const core::Angiogram& copy = read.value();
    ASSERT_EQ(copy.frameCount(), 3);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(copy.frames[k].pixels, original.frames[k].pixels);
    }
    EXPECT_EQ(copy.frameTimeMs, 66.6);
    EXPECT_EQ(copy.rWaveFrames, (std::vector<int>{0, 2}));
    EXPECT_EQ(copy.polarity, core::Polarity::VesselsBright);
    EXPECT_EQ(copy.cArm.sourceToDetectorMm.value, 1063.25);
    EXPECT_EQ(copy.cArm.sourceToIsocenterMm.value, 765.5);
    EXPECT_EQ(copy.cArm.sourceToObjectMm.value, 683.0);
    ASSERT_TRUE(copy.gantry.table);
    EXPECT_LT((copy.gantry.table->isocenterInPatientMm - Eigen::Vector3d(12.5, -7.25, 130.0)).norm(), 1e-6);
    EXPECT_FALSE(copy.gantry.tableMoves);
    EXPECT_EQ(copy.cArm.rowSpacingMm.value, 0.308);
    EXPECT_EQ(copy.cArm.columnSpacingMm.value, 0.309);
    EXPECT_EQ(copy.cArm.primaryAngleDeg.value, -31.4);
    EXPECT_EQ(copy.cArm.secondaryAngleDeg.value, 12.7);
    ASSERT_TRUE(copy.cArm.principalPointPx.value);
    EXPECT_NEAR(copy.cArm.principalPointPx.value->x(), 9.25, 1e-9);
    EXPECT_NEAR(copy.cArm.principalPointPx.value->y(), 8.5, 1e-9);
    EXPECT_EQ(copy.cArm.mirrored.value, true);
    EXPECT_EQ(copy.identity.patientName, "Müller^Ünal");
    EXPECT_EQ(copy.identity.studyDate, "2024-02-29");
}

TEST(WriteAngiogram, SpreadsFractionsOverSixteenBits)
{
    const test::TemporaryFolder folder;
    core::Angiogram original = smallRun();
    for (core::ImageF& frame : original.frames) {
        for (float& value : frame.pixels) {
            value = value / 4096.0F - 0.3F;
        }
    }
    ASSERT_TRUE(io::writeAngiogram(original, folder.file("run.dcm")));
    const auto read = io::readAngiogram(folder.file("run.dcm"));
    ASSERT_TRUE(read) << read.error().message;
    for (std::size_t i = 0; i < original.frames[1].pixels.size(); ++i) {
        EXPECT_NEAR(read.value().frames[1].pixels[i], original.frames[1].pixels[i], 1e-5);
    }
}

TEST(WriteAngiogram, GivesTheSameBytesForTheSameRun)
{
    const test::TemporaryFolder folder;
    ASSERT_TRUE(io::writeAngiogram(smallRun(), folder.file("a.dcm")));
    ASSERT_TRUE(io::writeAngiogram(smallRun(), folder.file("b.dcm")));
    EXPECT_EQ(test::readText(folder.file("a.dcm")), test::readText(folder.file("b.dcm")));
}

TEST(WriteAngiogram, RefusesWhatIsNoRun)
{
    const test::TemporaryFolder folder;
    EXPECT_FALSE(io::writeAngiogram({}, folder.file("none.dcm")));
    core::Angiogram broken = smallRun();
    broken.frames[1].pixels[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(io::writeAngiogram(broken, folder.file("nan.dcm")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("nan.dcm")));
}
