#include "io/case_file.h"

#include "tests/io/scratch_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

namespace {

core::RegistrationCase phantomCase(int view)
{
    std::vector<std::string> warnings;
    const auto path = test::dataFile("coronary-phantom-xa/cases/IM" + std::to_string(view) + ".angiopose");
    auto loaded = io::loadCase(path.string(), warnings);
    EXPECT_TRUE(loaded) << loaded.error().message;
    return loaded ? std::move(loaded).value() : core::RegistrationCase{};
}

}   // namespace

TEST(LoadCase, OpensEveryPhantomCase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    for (int view = 1; view <= 4; ++view) {
        const core::RegistrationCase loaded = phantomCase(view);
        ASSERT_TRUE(loaded.tree);
        EXPECT_EQ(loaded.tree->branches.size(), 11u);
        ASSERT_TRUE(loaded.angiogram);
        EXPECT_EQ(loaded.frame, loaded.angiogram->suggestedFrame);
        ASSERT_TRUE(loaded.cameraOverride);
        EXPECT_LT(loaded.cameraOverride->fx, 0.0);
        EXPECT_TRUE(loaded.hasInitialPose);
        EXPECT_TRUE(core::isRigid(loaded.cameraFromPatient, 1e-12));   // six digits in the file
        EXPECT_EQ(loaded.imageFile.sha256.size(), 64u);
    }
}

TEST(SaveCase, RestoresEveryBit)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::ScratchFolder folder;
    core::RegistrationCase original = phantomCase(3);
    original.title = "Größe \"π\"";
    original.auxiliaryBranchIds = {4, 5};
    original.excludedBranchIds = {11};
    original.frame = 7;
    original.options.finalScalePx = 1.0 / 3.0 + 1.0;
    original.traceOptions.sensitivity = 1.1;
    original.cArm.rollDeg = {0.1 + 0.2, core::Origin::User, ""};
    original.cameraFromPatient.translation.x() = 1.0 / 3.0;
    ASSERT_TRUE(io::saveCase(original, folder.path("copy.angiopose")));

    std::vector<std::string> warnings;
    const auto copy = io::loadCase(folder.path("copy.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().title, original.title);
    EXPECT_EQ(copy.value().cameraFromPatient.matrix(), original.cameraFromPatient.matrix());
    EXPECT_EQ(copy.value().initialCameraFromPatient.matrix(), original.initialCameraFromPatient.matrix());
    EXPECT_EQ(copy.value().auxiliaryBranchIds, original.auxiliaryBranchIds);
    EXPECT_EQ(copy.value().excludedBranchIds, original.excludedBranchIds);
    EXPECT_EQ(copy.value().frame, 7);
    EXPECT_EQ(copy.value().options, original.options);
    EXPECT_EQ(copy.value().traceOptions, original.traceOptions);
    EXPECT_EQ(copy.value().cArm.rollDeg.value, original.cArm.rollDeg.value);
    EXPECT_EQ(copy.value().cArm.columnSpacingMm.origin, core::Origin::Derived);
    EXPECT_EQ(copy.value().cameraOverride, original.cameraOverride);
    EXPECT_EQ(copy.value().centerlineFile, original.centerlineFile);
    EXPECT_TRUE(io::validateCase(folder.path("copy.angiopose")).value().empty());
}
