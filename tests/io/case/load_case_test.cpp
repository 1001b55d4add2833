#include "io/case/case_file.h"

#include "tests/io/case/small_case.h"

#include <gtest/gtest.h>
#include <filesystem>

using namespace angiopose;

namespace {

using test::anyContains;
using test::contains;
using test::SmallCase;

TEST(LoadCase, OpensEveryPhantomCase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    for (int view = 1; view <= 4; ++view) {
        const core::Case loaded = test::phantomCase(view);
        ASSERT_TRUE(loaded.vessels.tree);
        EXPECT_EQ(loaded.vessels.tree->branches.size(), 11u);
        ASSERT_TRUE(loaded.shown().angiogram);
        EXPECT_EQ(loaded.shown().frame, loaded.shown().angiogram->suggestedFrame);
        ASSERT_TRUE(loaded.shown().geometry.cameraOverride);
        EXPECT_LT(loaded.shown().geometry.cameraOverride->fx, 0.0);
        EXPECT_TRUE(loaded.shown().initialCameraFromPatient);
        EXPECT_TRUE(core::isRigid(loaded.shown().cameraFromPatient, 1e-12));   // only six digits in the file
        EXPECT_EQ(loaded.shown().imageFile.sha256.size(), 64u);
    }
}

TEST(LoadCase, OpensTheMinimalCase)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().vessels.tree->branches.size(), 2u);
    EXPECT_EQ(loaded.value().shown().cameraFromPatient.translation.z(), 740.0);
    EXPECT_EQ(loaded.value().options, core::RegistrationOptions());
    EXPECT_EQ(loaded.value().extraKeys, "");
    EXPECT_TRUE(std::filesystem::path(loaded.value().shown().imageFile.path).is_absolute());
}

TEST(LoadCase, FollowsTheAnglesWithoutAStartPose)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json.erase("pose");
    EXPECT_TRUE(contains(small.errorOf(json), "pose.initial"));
    json["geometry"]["sourceToPatientMm"] = 700;
    json["geometry"]["primaryAngleDeg"] = {{"value", 30}, {"origin", "assumed"}};
    json["geometry"]["secondaryAngleDeg"] = 0;
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_FALSE(loaded.value().shown().initialCameraFromPatient);
    const Eigen::Vector3d centroid = core::centroidInPatient(*loaded.value().vessels.tree);
    EXPECT_NEAR((loaded.value().shown().cameraFromPatient * centroid - Eigen::Vector3d(0, 0, 700)).norm(), 0.0, 1e-9);
    EXPECT_EQ(loaded.value().shown().geometry.cArm.primaryAngleDeg.origin, core::Origin::Assumed);
    EXPECT_EQ(loaded.value().shown().geometry.cArm.sourceToIsocenterMm.origin, core::Origin::User);
}

TEST(LoadCase, TakesTheDistanceOfOlderFilesForWhatItWas)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["geometry"]["sourceToPatientMm"] = {
        {"value", 683}, {"origin", "header"}, {"basis", "(0018,1111) Distance Source to Patient"}};
    auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const core::CArm object = loaded.value().shown().geometry.cArm;
    EXPECT_EQ(object.sourceToObjectMm.value, 683.0);
    EXPECT_EQ(object.sourceToIsocenterMm.origin, core::Origin::Assumed) << "no header calls it the isocenter";
    json["geometry"]["sourceToPatientMm"]["basis"] = "(0018,9402) Distance Source to Isocenter";
    loaded = small.load(json);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded.value().shown().geometry.cArm.sourceToIsocenterMm.origin, core::Origin::Header);
}

TEST(LoadCase, MakesRoundedPosesRigidAndRefusesOthers)
{
    SmallCase small;
    nlohmann::json json = small.json();
    auto& matrix = json["pose"]["initial"]["cameraFromPatient"];
    matrix[0] = {0.866025, -0.5, 0, 1};
    matrix[1] = {0.5, 0.866025, 0, 2};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(core::isRigid(loaded.value().shown().cameraFromPatient, 1e-14));
    EXPECT_NEAR(loaded.value().shown().cameraFromPatient.rotation(0, 0), 0.8660254, 1e-6);

    matrix[0] = {1.01, 0, 0, 0};
    matrix[1] = {0, 1, 0, 0};
    EXPECT_TRUE(contains(small.errorOf(json), "not a rotation"));
    matrix[0] = {-1, 0, 0, 0};
    EXPECT_TRUE(contains(small.errorOf(json), "reflection"));
    matrix[0] = {1, 0, 0, 0};
    matrix[3] = {0, 0, 740, 1};
    EXPECT_TRUE(contains(small.errorOf(json), "last row"));
    matrix[3] = {0, 0, 1};
    EXPECT_TRUE(contains(small.errorOf(json), "pose.initial.cameraFromPatient"));
    matrix = nullptr;
    EXPECT_TRUE(contains(small.errorOf(json), "cameraFromPatient"));
}

TEST(LoadCase, NamesWhatIsWrong)
{
    SmallCase small;
    const auto with = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json json = small.json();
        json[nlohmann::json::json_pointer(pointer)] = value;
        return small.errorOf(json);
    };
    EXPECT_TRUE(contains(with("/angiogram/frame", 3), "frames 0 to 0"));
    EXPECT_TRUE(contains(with("/angiogram/frame", -1), "angiogram.frame"));
    EXPECT_TRUE(contains(with("/vessel/centerline/path", "none.vtp"), "does not exist"));
    EXPECT_TRUE(contains(with("/angiogram/image/path", "in"), "folder"));
    EXPECT_TRUE(contains(with("/version", 2), "newer"));
    EXPECT_TRUE(contains(with("/format", "something"), "format"));
    EXPECT_TRUE(contains(with("/method", "magic"), "dynaweight"));
    EXPECT_TRUE(contains(with("/options/finalScalePx", -5), "options"));
    EXPECT_TRUE(contains(with("/geometry/camera/fx", 0), "geometry.camera"));
    EXPECT_TRUE(contains(with("/geometry/camera/width", 512), "16 × 12"));
    EXPECT_TRUE(contains(with("/geometry/sourceToDetectorMm", "far"), "geometry.sourceToDetectorMm"));
    nlohmann::json volume = small.json();
    volume["vessel"] = {{"volume", {{"path", "ct.nii.gz"}}}};
    EXPECT_TRUE(contains(small.errorOf(volume), "does not exist"));
    volume["vessel"] = nlohmann::json::object();
    EXPECT_TRUE(contains(small.errorOf(volume), "segmentation, surface or volume"));
    volume["vessel"] = {{"segmentation", {{"path", "mask.nii"}}}, {"unitMm", -1}};
    EXPECT_TRUE(contains(small.errorOf(volume), "vessel.unitMm"));
}

TEST(LoadCase, NamesTheLineOfBrokenJson)
{
    const test::TemporaryFolder folder;
    core::Messages warnings;
    const auto broken = io::loadCase(folder.write("a.angiopose", "{\n\"format\": 1,\n]"), warnings);
    ASSERT_FALSE(broken);
    EXPECT_TRUE(contains(broken.error().message.text(), "line 3"));
    const auto nan = io::loadCase(folder.write("b.angiopose", "{\"version\": NaN}"), warnings);
    EXPECT_TRUE(contains(nan.error().message.text(), "JSON is invalid"));
    const auto deep = io::loadCase(folder.write("c.angiopose", std::string(200000, '[')), warnings);
    EXPECT_TRUE(contains(deep.error().message.text(), "nested"));
}

TEST(LoadCase, LeavesOutUnknownBranchesWithAWarning)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["vessel"]["auxiliaryBranches"] = {2, 77};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded.value().vessels.auxiliaryBranchIds, std::vector<int>{2});
    EXPECT_TRUE(anyContains(small.warnings, "no branch 77"));
}

TEST(LoadCase, WarnsOfChangedInputs)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    core::Messages warnings;
    ASSERT_TRUE(io::loadCase(small.path("saved.angiopose"), warnings));
    EXPECT_FALSE(anyContains(warnings, "has changed"));
    small.folder().write("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,1,1\n");
    ASSERT_TRUE(io::loadCase(small.path("saved.angiopose"), warnings));
    EXPECT_TRUE(anyContains(warnings, "tree.csv: the file has changed"));
}

TEST(LoadCase, WarnsOfMissingSpacingOnlyWhereItMatters)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const auto phantom = test::dataFile("coronary-phantom-xa");
    SmallCase small;
    nlohmann::json json = small.json();
    json["vessel"]["centerline"]["path"] = (phantom / "tree/Centerlines.vtk").string();
    json["angiogram"]["image"]["path"] = (phantom / "views-A/IM3.dcm").string();
    json["geometry"]["camera"].update({{"width", 512}, {"height", 512}});
    ASSERT_TRUE(small.load(json));
    EXPECT_FALSE(anyContains(small.warnings, "imager pixel spacing"));
    json["geometry"] = {{"imagerPixelSpacingMm", {0.3, 0.3}}};
    ASSERT_TRUE(small.load(json));
    EXPECT_FALSE(anyContains(small.warnings, "imager pixel spacing"));
    json["geometry"] = nlohmann::json::object();
    ASSERT_TRUE(small.load(json));
    EXPECT_TRUE(anyContains(small.warnings, "imager pixel spacing"));
}

}   // namespace
