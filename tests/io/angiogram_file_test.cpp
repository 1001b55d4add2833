#include "io/angiogram_file.h"

#include "tests/support/test_data.h"

#include <gtest/gtest.h>

namespace {

core::Angiogram phantomView(int view)
{
    const auto path = test::dataFile("coronary-phantom-xa/views-A/IM" + std::to_string(view) + ".dcm");
    auto angiogram = io::readAngiogram(path.string());
    EXPECT_TRUE(angiogram) << angiogram.error().message;
    return angiogram ? std::move(angiogram).value() : core::Angiogram{};
}

}   // namespace

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
        const core::Angiogram angiogram = phantomView(view);
        const Expected& wanted = expected[view - 1];
        EXPECT_EQ(angiogram.frameCount(), wanted.frames);
        EXPECT_EQ(angiogram.width(), 512);
        EXPECT_EQ(angiogram.height(), 512);
        EXPECT_EQ(angiogram.cArm.primaryAngleDeg.value, wanted.primaryDeg);
        EXPECT_EQ(angiogram.cArm.secondaryAngleDeg.value, wanted.secondaryDeg);
        EXPECT_EQ(angiogram.cArm.sourceToDetectorMm.value, wanted.sidMm);
        EXPECT_EQ(angiogram.cArm.sourceToPatientMm.value, 720.0);
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
    const core::Angiogram angiogram = phantomView(1);   // (0018,1164) is absent
    EXPECT_EQ(angiogram.cArm.columnSpacingMm.origin, core::Origin::Derived);
    EXPECT_NEAR(*angiogram.cArm.columnSpacingMm.value, 0.390625, 1e-12);
    EXPECT_NE(angiogram.cArm.columnSpacingMm.basis.find("field of view"), std::string::npos);
    ASSERT_EQ(angiogram.warnings.size(), 1u);
    EXPECT_NE(angiogram.warnings.front().find("(0018,1164)"), std::string::npos);
}
