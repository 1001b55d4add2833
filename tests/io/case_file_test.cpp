#include "io/case_file.h"

#include "io/file_hash.h"
#include "io/image_file.h"
#include "io/volume_file.h"
#include "tests/io/scratch_folder.h"
#include "tests/support/forked_vessel.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

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

namespace {

core::RegistrationCase withEditedCurves(core::RegistrationCase values)
{
    const core::Curve2d curve{4, {{1.0 / 3.0, 2.5}, {7.0, 9.0}, {11.25, 1e-3}}, {1.5, 2.0, 0.1}};
    values.givenTarget = std::make_shared<core::Centerline2d>(core::Centerline2d{{curve}});
    values.editedFrame = values.frame;
    values.acceptedCurveIds = {4};
    return values;
}

core::RegistrationCase reloaded(const std::string& path)
{
    std::vector<std::string> warnings;
    auto loaded = io::loadCase(path, warnings);
    EXPECT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded && io::validateCase(path).value().empty());
    return loaded ? std::move(loaded).value() : core::RegistrationCase{};
}

bool hasFile(const test::ScratchFolder& folder, const std::string& name)
{
    return std::filesystem::exists(folder.path(name));
}

}   // namespace

TEST(SaveCase, KeepsEditedCurvesBesideTheCase)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::ScratchFolder folder;
    const core::RegistrationCase original = withEditedCurves(phantomCase(3));
    ASSERT_TRUE(io::saveCase(original, folder.path("a.angiopose")));
    const core::RegistrationCase copy = reloaded(folder.path("a.angiopose"));
    EXPECT_EQ(copy.targetFile.path, folder.path("a.curves.csv"));
    ASSERT_TRUE(copy.givenTarget);
    EXPECT_EQ(copy.givenTarget->curves.front().id, 4);
    EXPECT_EQ(copy.givenTarget->curves.front().pointsPx, original.givenTarget->curves.front().pointsPx);
    EXPECT_EQ(copy.givenTarget->curves.front().radiusPx, original.givenTarget->curves.front().radiusPx);
    EXPECT_EQ(copy.editedFrame, original.frame);
    EXPECT_EQ(copy.acceptedCurveIds, std::vector<int>{4});
    EXPECT_EQ(core::targetOf(copy).value().pointCount(), 3U) << "what the command line registers";

    core::RegistrationCase elsewhere = copy;
    elsewhere.frame = copy.frame + 1;
    EXPECT_FALSE(core::givenTargetOf(elsewhere)) << "curves of one frame do not stand for another";
}

TEST(SaveCase, EditedCurvesReplaceTheirOwnFileOnly)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::ScratchFolder folder;
    std::ofstream(folder.path("a.curves.csv")) << "of somebody else";
    const core::RegistrationCase original = withEditedCurves(phantomCase(3));
    ASSERT_TRUE(io::saveCase(original, folder.path("a.angiopose")));
    ASSERT_TRUE(io::saveCase(original, folder.path("a.angiopose")));
    EXPECT_TRUE(hasFile(folder, "a.curves-2.csv"));
    EXPECT_FALSE(hasFile(folder, "a.curves-3.csv"));
    std::string kept;
    std::getline(std::ifstream(folder.path("a.curves.csv")), kept);
    EXPECT_EQ(kept, "of somebody else");

    // Saved under another name, the case takes its curves along.
    ASSERT_TRUE(io::saveCase(reloaded(folder.path("a.angiopose")), folder.path("b.angiopose")));
    EXPECT_EQ(reloaded(folder.path("b.angiopose")).targetFile.path, folder.path("b.curves.csv"));
}

TEST(SaveCase, RestoresTheSubtraction)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::ScratchFolder folder;
    core::RegistrationCase original = phantomCase(4);
    original.treatment.isSubtracted = true;
    original.treatment.plan.maskFrames = {0, 1};
    original.treatment.plan.maskShiftPx = Eigen::Vector2d(0.25, -1.0 / 3.0);
    original.treatment.plan.relation = core::PixelRelation::Logarithmic;
    const auto treated = core::treatedRun(*original.angiogram, original.treatment);
    ASSERT_TRUE(treated) << treated.error().message;
    original.storedRun = original.angiogram;
    original.angiogram = std::make_shared<core::Angiogram>(treated.value());
    ASSERT_TRUE(io::saveCase(original, folder.path("dsa.angiopose")));

    const core::RegistrationCase copy = reloaded(folder.path("dsa.angiopose"));
    EXPECT_EQ(copy.treatment, original.treatment);
    ASSERT_TRUE(copy.storedRun);
    EXPECT_EQ(copy.storedRun->frames[4].pixels, original.storedRun->frames[4].pixels);
    EXPECT_EQ(copy.angiogram->frames[4].pixels, original.angiogram->frames[4].pixels);
    EXPECT_NE(copy.angiogram->frames[4].pixels, copy.storedRun->frames[4].pixels);
}

TEST(LoadCase, SubtractionThatCannotBeIsRefused)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const test::ScratchFolder folder;
    core::RegistrationCase original = phantomCase(4);
    original.treatment.isSubtracted = true;
    original.treatment.plan.maskFrames = {99};
    ASSERT_TRUE(io::saveCase(original, folder.path("dsa.angiopose")));
    std::vector<std::string> warnings;
    const auto loaded = io::loadCase(folder.path("dsa.angiopose"), warnings);
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error().message.find("Mask frame 99"), std::string::npos) << loaded.error().message;
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
    original.options.locks = {true, false, true, false, true, false};
    original.traceOptions.sensitivity = 1.1;
    original.cArm.rollDeg = {0.1 + 0.2, core::Origin::User, ""};
    original.cArm.isocentreInPatientMm = {Eigen::Vector3d(0.1, -1.0 / 3.0, 7e5), core::Origin::Derived, "clicked"};
    original.landmarks = {{{1.0 / 3.0, -2.0, 600.5}, {10.1, 511.0 / 3.0}, "bifurcation 3 / 5"},
                          {{1, 2, 3}, {4, 5}, ""}};
    original.otherViews = {{folder.path("other.angiopose"), ""}};
    original.cameraFromPatient.translation.x() = 1.0 / 3.0;
    ASSERT_TRUE(io::saveCase(original, folder.path("copy.angiopose")));

    std::vector<std::string> warnings;
    const auto copy = io::loadCase(folder.path("copy.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().title, original.title);
    EXPECT_EQ(copy.value().cameraFromPatient.matrix(), original.cameraFromPatient.matrix());
    EXPECT_EQ(copy.value().initialCameraFromPatient.matrix(), original.initialCameraFromPatient.matrix());
    EXPECT_EQ(copy.value().landmarks, original.landmarks);
    EXPECT_EQ(copy.value().otherViews, original.otherViews);
    EXPECT_EQ(copy.value().cArm.isocentreInPatientMm.value, original.cArm.isocentreInPatientMm.value);
    EXPECT_EQ(copy.value().cArm.isocentreInPatientMm.basis, "clicked");
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

namespace {

/// A folder with a small tree, a small image and the text of a minimal case.
class SmallCase {
public:
    SmallCase()
    {
        folder_.write("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n20,1,0,1\n10,0,0,2\n10,8,0,2\n");
        core::ColorImage picture{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 90)};
        picture.rgb[100] = 10;
        EXPECT_TRUE(io::writePng(picture, folder_.path("in/image.png")));
    }

    nlohmann::json json() const
    {
        return nlohmann::json::parse(R"({
            "format": "angiopose-case", "version": 1,
            "vessel": { "centerline": { "path": "in/tree.csv" } },
            "angiogram": { "image": { "path": "in/image.png" }, "frame": 0 },
            "geometry": { "camera": { "fx": -2000, "fy": 2000, "cx": 7.5, "cy": 5.5, "width": 16, "height": 12 } },
            "pose": { "initial": { "cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]] } } })");
    }

    std::string write(const nlohmann::json& json) const { return folder_.write("case.angiopose", json.dump()); }
    std::string path(const std::string& name) const { return folder_.path(name); }
    const test::ScratchFolder& folder() const { return folder_; }

    core::Result<core::RegistrationCase> load(const nlohmann::json& json)
    {
        warnings.clear();
        return io::loadCase(write(json), warnings);
    }

    std::string errorOf(const nlohmann::json& json)
    {
        const auto loaded = load(json);
        return loaded ? "loaded" : loaded.error().message;
    }

    std::vector<std::string> warnings;

private:
    test::ScratchFolder folder_;
};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

bool anyContains(const std::vector<std::string>& texts, const std::string& part)
{
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) { return contains(text, part); });
}

/// A locale with a decimal comma: the installed one, or one made for this test.
bool setGermanLocale(const std::string& folder)
{
    if (std::setlocale(LC_ALL, "de_DE.UTF-8")) {
        return true;
    }
    std::filesystem::create_directory(folder);
    const std::string command = "localedef -i de_DE -f UTF-8 " + folder + "/de_DE.UTF-8 > /dev/null 2>&1";
    return std::system(command.c_str()) == 0 && ::setenv("LOCPATH", folder.c_str(), 1) == 0 &&
           std::setlocale(LC_ALL, "de_DE.UTF-8");
}

}   // namespace

TEST(LoadCase, OpensTheMinimalCase)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().tree->branches.size(), 2u);
    EXPECT_EQ(loaded.value().cameraFromPatient.translation.z(), 740.0);
    EXPECT_EQ(loaded.value().options, core::RegistrationOptions());
    EXPECT_EQ(loaded.value().extraKeys, "");
    EXPECT_TRUE(std::filesystem::path(loaded.value().imageFile.path).is_absolute());
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
    EXPECT_FALSE(loaded.value().hasInitialPose);
    const Eigen::Vector3d centroid = core::centroidInPatient(*loaded.value().tree);
    EXPECT_NEAR((loaded.value().cameraFromPatient * centroid - Eigen::Vector3d(0, 0, 700)).norm(), 0.0, 1e-9);
    EXPECT_EQ(loaded.value().cArm.primaryAngleDeg.origin, core::Origin::Assumed);
    EXPECT_EQ(loaded.value().cArm.sourceToPatientMm.origin, core::Origin::User);
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
    EXPECT_TRUE(core::isRigid(loaded.value().cameraFromPatient, 1e-14));
    EXPECT_NEAR(loaded.value().cameraFromPatient.rotation(0, 0), 0.8660254, 1e-6);

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
    EXPECT_TRUE(contains(with("/vessel/centerline/path", "none.vtp"), "no such file"));
    EXPECT_TRUE(contains(with("/angiogram/image/path", "in"), "folder"));
    EXPECT_TRUE(contains(with("/version", 2), "newer"));
    EXPECT_TRUE(contains(with("/format", "something"), "format"));
    EXPECT_TRUE(contains(with("/method", "magic"), "dynaweight"));
    EXPECT_TRUE(contains(with("/options/finalScalePx", -5), "options"));
    EXPECT_TRUE(contains(with("/geometry/camera/fx", 0), "geometry.camera"));
    EXPECT_TRUE(contains(with("/geometry/camera/width", 512), "16 x 12"));
    EXPECT_TRUE(contains(with("/geometry/sourceToDetectorMm", "far"), "geometry.sourceToDetectorMm"));
    nlohmann::json volume = small.json();
    volume["vessel"] = {{"volume", {{"path", "ct.nii.gz"}}}};
    EXPECT_TRUE(contains(small.errorOf(volume), "no such file"));
    volume["vessel"] = nlohmann::json::object();
    EXPECT_TRUE(contains(small.errorOf(volume), "segmentation, surface or volume"));
    volume["vessel"] = {{"segmentation", {{"path", "mask.nii"}}}, {"unitMm", -1}};
    EXPECT_TRUE(contains(small.errorOf(volume), "vessel.unitMm"));
}

TEST(LoadCase, TracesASegmentationWithTheParametersBesideIt)
{
    SmallCase small;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), small.path("in/mask.nii.gz")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"segmentation", {{"path", "in/mask.nii.gz"}}},
                      {"labels", {2}},
                      {"surface", {{"path", "other.stl"}, {"note", "kept"}}},
                      {"tracing", {{"minBranchLengthMm", 7.5}, {"rootInPatientMm", {0, 0, 0}}, {"mine", true}}}};

    const auto loaded = small.load(json);

    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(test::endsOf(*loaded.value().tree), 3);
    for (const core::VesselBranch& branch : loaded.value().tree->branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            EXPECT_LT(test::distanceToFork(point), 1.5);
        }
    }
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("copy.angiopose")));
    std::vector<std::string> warnings;
    const auto copy = io::loadCase(small.path("copy.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().vesselInput, loaded.value().vesselInput);
    EXPECT_EQ(copy.value().vesselInput.tracing.minBranchLengthMm, 7.5);
    EXPECT_EQ(copy.value().centerlineFile, loaded.value().centerlineFile);
    EXPECT_EQ(copy.value().tree->branches.front().pointsInPatient,
              loaded.value().tree->branches.front().pointsInPatient);
    const auto saved = nlohmann::json::parse(test::contentOf(small.path("copy.angiopose")));
    EXPECT_EQ(saved["vessel"]["surface"]["note"], "kept") << "another kind beside it survives";
    EXPECT_EQ(saved["vessel"]["tracing"]["mine"], true);
    EXPECT_TRUE(io::validateCase(small.path("copy.angiopose")).value().empty());
}

namespace {

/// The tree of the small case with its second branch renamed and a point moved by an odd amount.
std::shared_ptr<const core::VesselTree> editedTree(const core::RegistrationCase& values)
{
    core::VesselTree tree = *values.tree;
    tree.branches[1].name = "Äste \"2\"";
    tree.branches[1].generation = 1;
    tree.branches[1].pointsInPatient[1].y() += 1.0 / 3.0;
    tree.branches[1].radiusMm = {1.1, 0.1 + 0.2};
    return std::make_shared<const core::VesselTree>(std::move(tree));
}

}   // namespace

TEST(SaveCase, KeepsAnEditedTreeToTheLastBit)
{
    SmallCase small;
    core::RegistrationCase edited = small.load(small.json()).value();
    edited.tree = editedTree(edited);
    edited.isTreeEdited = true;
    edited.hiddenBranchIds = {2};
    const std::string input = small.path("in/tree.csv");
    const auto before = io::sha256OfFile(input).value();
    ASSERT_TRUE(io::saveCase(edited, small.path("edited.angiopose")));

    EXPECT_EQ(io::sha256OfFile(input).value(), before);
    EXPECT_TRUE(io::validateCase(small.path("edited.angiopose")).value().empty());
    std::vector<std::string> warnings;
    const auto copy = io::loadCase(small.path("edited.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(warnings, small.warnings);   // those of the image, none of the tree
    EXPECT_TRUE(copy.value().isTreeEdited);
    EXPECT_EQ(copy.value().hiddenBranchIds, std::vector{2});
    ASSERT_EQ(copy.value().tree->branches.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const core::VesselBranch& a = edited.tree->branches[i];
        const core::VesselBranch& b = copy.value().tree->branches[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.generation, b.generation);
        EXPECT_EQ(a.pointsInPatient, b.pointsInPatient);
        EXPECT_EQ(a.radiusMm, b.radiusMm);
    }
}

TEST(LoadCase, OpensAnEditedTreeWithoutItsOrigin)
{
    SmallCase small;
    core::RegistrationCase edited = small.load(small.json()).value();
    edited.tree = editedTree(edited);
    edited.isTreeEdited = true;
    ASSERT_TRUE(io::saveCase(edited, small.path("edited.angiopose")));
    std::filesystem::remove(small.path("in/tree.csv"));

    std::vector<std::string> warnings;
    const auto copy = io::loadCase(small.path("edited.angiopose"), warnings);
    ASSERT_TRUE(copy) << copy.error().message;
    EXPECT_EQ(copy.value().tree->branches[1].name, edited.tree->branches[1].name);
    EXPECT_EQ(copy.value().centerlineFile.sha256, edited.centerlineFile.sha256);
    EXPECT_TRUE(anyContains(warnings, "opens without the file"));
}

TEST(LoadCase, RefusesAnEditedTreeThatIsNone)
{
    SmallCase small;
    nlohmann::json json = small.json();
    const auto branch = nlohmann::json::parse(R"({"id": 1, "pointsMm": [[0,0,0],[0,0,1]]})");
    json["vessel"]["editedTree"]["branches"] = {branch, branch};
    EXPECT_TRUE(contains(small.errorOf(json), "branch 1 is there twice"));
    json["vessel"]["editedTree"]["branches"] = nlohmann::json::array();
    EXPECT_TRUE(contains(small.errorOf(json), "vessel.editedTree"));
    json["vessel"]["editedTree"]["branches"] = {{{"id", 1}, {"pointsMm", {{0, 0}, {1, 1}}}}};
    EXPECT_TRUE(contains(small.errorOf(json), "vessel.editedTree"));
}

TEST(LoadCase, ReadsTheScanOfAnEditedTreeWithoutTracingIt)
{
    SmallCase small;
    ASSERT_TRUE(io::writeVolume(test::forkScan(), small.path("in/scan.nrrd")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"volume", {{"path", "in/scan.nrrd"}}}};
    json["vessel"]["editedTree"]["branches"] = {{{"id", 5}, {"pointsMm", {{0, 0, 0}, {0, 0, 30}}}}};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_TRUE(loaded.value().volume);
    ASSERT_EQ(loaded.value().tree->branches.size(), 1U);
    EXPECT_EQ(loaded.value().tree->branches[0].id, 5);
    EXPECT_FALSE(loaded.value().lumen);
}

TEST(LoadCase, ReadsTheScanThatOtherVesselsLieIn)
{
    SmallCase small;
    ASSERT_TRUE(io::writeVolume(test::forkScan(), small.path("in/scan.nrrd")));
    nlohmann::json json = small.json();
    json["vessel"]["volume"]["path"] = "in/scan.nrrd";
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded.value().vesselInput.kind, core::VesselInputKind::Centerline);
    EXPECT_EQ(loaded.value().tree->branches.size(), 2U);
    ASSERT_TRUE(loaded.value().volume);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("copy.angiopose")));
    std::vector<std::string> warnings;
    EXPECT_EQ(io::loadCase(small.path("copy.angiopose"), warnings).value().scanFile, loaded.value().scanFile);
    EXPECT_EQ(warnings, small.warnings);   // those of the image, none of the scan

    json["vessel"]["volume"]["path"] = "in/gone.nrrd";
    const auto without = small.load(json);
    ASSERT_TRUE(without) << without.error().message;
    EXPECT_FALSE(without.value().volume);
    EXPECT_TRUE(anyContains(small.warnings, "gone.nrrd"));
}

TEST(LoadCase, StopsTracingWhenAsked)
{
    SmallCase small;
    ASSERT_TRUE(io::writeLabels(test::forkLabels(), small.path("in/mask.nii.gz")));
    nlohmann::json json = small.json();
    json["vessel"] = {{"segmentation", {{"path", "in/mask.nii.gz"}}}};
    std::vector<std::string> warnings;
    const auto stopped = io::loadCase(small.write(json), warnings, [](double) { return core::Verdict::Stop; });
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(contains(stopped.error().message, "stopped"));
}

TEST(LoadCase, NamesTheLineOfBrokenJson)
{
    const test::ScratchFolder folder;
    std::vector<std::string> warnings;
    const auto broken = io::loadCase(folder.write("a.angiopose", "{\n\"format\": 1,\n]"), warnings);
    ASSERT_FALSE(broken);
    EXPECT_TRUE(contains(broken.error().message, "line 3"));
    const auto nan = io::loadCase(folder.write("b.angiopose", "{\"version\": NaN}"), warnings);
    EXPECT_TRUE(contains(nan.error().message, "not valid JSON"));
    const auto deep = io::loadCase(folder.write("c.angiopose", std::string(200000, '[')), warnings);
    EXPECT_TRUE(contains(deep.error().message, "nested"));
}

TEST(LoadCase, LeavesOutUnknownBranchesWithAWarning)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["vessel"]["auxiliaryBranches"] = {2, 77};
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded.value().auxiliaryBranchIds, std::vector<int>{2});
    EXPECT_TRUE(anyContains(small.warnings, "no branch 77"));
}

TEST(LoadCase, WarnsOfChangedInputs)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    std::vector<std::string> warnings;
    ASSERT_TRUE(io::loadCase(small.path("saved.angiopose"), warnings));
    EXPECT_FALSE(anyContains(warnings, "has changed"));
    small.folder().write("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,1,1\n");
    ASSERT_TRUE(io::loadCase(small.path("saved.angiopose"), warnings));
    EXPECT_TRUE(anyContains(warnings, "tree.csv: the file has changed"));
}

TEST(SaveCase, KeepsKeysItDoesNotKnow)
{
    SmallCase small;
    nlohmann::json json = small.json();
    json["site"] = {{"name", "Kragujevac"}, {"empty", nlohmann::json::object()}};
    json["vessel"]["centerline"]["tracedBy"] = "A. B.";
    json["pose"]["history"] = {1, 2.5, nullptr};
    json["options"]["futureKnob"] = 0.1;
    json["geometry"]["tableHeightMm"] = -12.25;
    const auto loaded = small.load(json);
    ASSERT_TRUE(loaded) << loaded.error().message;
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    const nlohmann::json saved = nlohmann::json::parse(test::contentOf(small.path("saved.angiopose")));
    EXPECT_EQ(saved["site"], json["site"]);
    EXPECT_EQ(saved["vessel"]["centerline"]["tracedBy"], "A. B.");
    EXPECT_EQ(saved["vessel"]["centerline"]["path"], "in/tree.csv");
    EXPECT_EQ(saved["pose"]["history"], json["pose"]["history"]);
    EXPECT_EQ(saved["options"]["futureKnob"], 0.1);
    EXPECT_EQ(saved["geometry"]["tableHeightMm"], -12.25);
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    ASSERT_TRUE(again);
    EXPECT_EQ(nlohmann::json::parse(again.value().extraKeys), nlohmann::json::parse(loaded.value().extraKeys));
}

TEST(SaveCase, NeverOverwritesAnInput)
{
    SmallCase small;
    const auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    const std::string before = test::contentOf(small.path("in/tree.csv"));
    std::filesystem::create_symlink(small.path("in/tree.csv"), small.path("link.angiopose"));
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("in/tree.csv")));
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("link.angiopose")));
    EXPECT_EQ(test::contentOf(small.path("in/tree.csv")), before);
}

TEST(SaveCase, LeavesTheOldFileWhenItCannotWrite)
{
    SmallCase small;
    auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    ASSERT_TRUE(io::saveCase(loaded.value(), small.path("saved.angiopose")));
    const std::string before = test::contentOf(small.path("saved.angiopose"));
    core::RegistrationCase broken = loaded.value();
    broken.cameraFromPatient.translation.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(io::saveCase(broken, small.path("saved.angiopose")));
    EXPECT_EQ(test::contentOf(small.path("saved.angiopose")), before);
    EXPECT_FALSE(io::saveCase(loaded.value(), small.path("absent/folder/saved.angiopose")));
    for (const auto& entry : std::filesystem::directory_iterator(small.path(""))) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << "temporary file left behind";
    }
}

TEST(SaveCase, WritesDecimalPointsInAnyLocale)
{
    SmallCase small;
    auto loaded = small.load(small.json());
    ASSERT_TRUE(loaded);
    core::RegistrationCase values = loaded.value();
    values.cArm.rollDeg = {1.0 / 3.0, core::Origin::User, ""};
    if (!setGermanLocale(small.path("locale"))) {
        GTEST_SKIP() << "locale de_DE.UTF-8 is neither installed nor can it be made (package locales)";
    }
    ASSERT_EQ(*std::localeconv()->decimal_point, ',');
    const bool saved = static_cast<bool>(io::saveCase(values, small.path("saved.angiopose")));
    const auto again = io::loadCase(small.path("saved.angiopose"), small.warnings);
    std::setlocale(LC_ALL, "C");
    ASSERT_TRUE(saved);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again.value().cArm.rollDeg.value, 1.0 / 3.0);
    EXPECT_TRUE(contains(test::contentOf(small.path("saved.angiopose")), "0.3333333333333333"));
}

TEST(ValidateCase, ListsEveryProblem)
{
    SmallCase small;
    nlohmann::json json = small.json();
    EXPECT_TRUE(io::validateCase(small.write(json)).value().empty());
    json["vessel"]["centerline"]["path"] = "gone.vtp";
    json["angiogram"]["image"]["path"] = "gone.dcm";
    json["geometry"]["camera"]["fx"] = 0;
    const auto problems = io::validateCase(small.write(json));
    ASSERT_TRUE(problems);
    EXPECT_EQ(problems.value().size(), 3u);
    EXPECT_TRUE(anyContains(problems.value(), "gone.dcm"));
    EXPECT_TRUE(anyContains(problems.value(), "geometry.camera"));
}

TEST(DoubtsOfCase, HoldTheCaseAgainstTheHeaderOfItsImage)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/cases");
    const auto phantom = test::dataFile("coronary-phantom-xa");
    const auto doubtsWith = [&](const std::string& geometry) {
        const test::ScratchFolder folder;
        const std::string path =
            folder.write("case.angiopose",
                         R"({"format": "angiopose-case", "version": 1, "vessel": {"centerline": {"path": ")" +
                             (phantom / "tree/Centerlines.vtk").string() + R"("}}, "angiogram": {"image": {"path": ")" +
                             (phantom / "views-A/IM3.dcm").string() + R"("}}, "geometry": )" + geometry + "}");
        const auto doubts = io::doubtsOfCase(path);
        EXPECT_TRUE(doubts) << doubts.error().message;
        return doubts ? doubts.value() : std::vector<std::string>{};
    };
    EXPECT_TRUE(doubtsWith("{}").empty());
    ASSERT_EQ(doubtsWith(R"({"sourceToPatientMm": 900})").size(), 1U);
    EXPECT_NE(doubtsWith(R"({"sourceToPatientMm": 900})").front().find("behind the detector"), std::string::npos);
    EXPECT_NE(doubtsWith(R"({"imagerPixelSpacingMm": [0.2, 0.2]})").front().find("field of view"), std::string::npos);
}

TEST(CaseSchema, IsThePublishedFile)
{
    const nlohmann::json schema = nlohmann::json::parse(io::caseSchema());
    EXPECT_EQ(schema["title"], "AngioPose case");
    EXPECT_TRUE(schema["definitions"].contains("pose"));
}
