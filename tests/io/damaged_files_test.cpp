#include "core/support/random.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/image_file.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

// Valid small files, truncated and with flipped bits: anything that is read is valid, and nothing crashes.

namespace {

core::VesselTree twoBranches()
{
    core::VesselTree tree;
    for (int id : {3, 8}) {
        core::VesselBranch branch{id, "branch", {}, {}};
        for (int i = 0; i < 12; ++i) {
            branch.pointsInPatient.emplace_back(i, id * 0.1 * i * i, 100.0 - i);
            branch.radiusMm.push_back(1.0 + 0.1 * i);
        }
        tree.branches.push_back(branch);
    }
    return tree;
}

core::Angiogram twoFrames()
{
    core::Angiogram angiogram;
    angiogram.frames.assign(2, core::ImageF(24, 18, 100.0F));
    angiogram.frames[1].at(3, 4) = 700.0F;
    angiogram.frameTimeMs = 66.0;
    angiogram.cArm.sourceToDetectorMm = {1000.0, core::Origin::Header, ""};
    return angiogram;
}

constexpr const char* legacyText =
    "# vtk DataFile Version 3.0\nlines\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 2 0 1 3 1 1\n"
    "LINES 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS Radius float 1\nLOOKUP_TABLE default\n1 1 2 2\n"
    "CELL_DATA 1\nFIELD FieldData 1\nGroupIds 1 1 int\n7\n";

constexpr const char* swcText =
    "# id type x y z r parent\n1 2 0 0 0 1 -1\n2 2 1 0 0 1 1\n3 2 2 0 0 1 2\n4 2 2 1 0 1 2\n";

void readAsEverything(const std::string& path)
{
    if (const auto tree = io::readVesselTree(path); tree) {
        EXPECT_FALSE(core::findProblem(tree.value()));
    }
    if (const auto angiogram = io::readAngiogram(path); angiogram) {
        for (const core::ImageF& frame : angiogram.value().frames) {
            EXPECT_EQ(frame.pixels.size(),
                      static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
        }
    }
    if (const auto target = io::readCenterline2d(path); target) {
        EXPECT_FALSE(core::findProblem(target.value()));
    }
    if (const auto pose = io::readPose(path); pose) {
        EXPECT_TRUE(core::isRigid(pose.value()));
    }
    core::Messages warnings;
    (void)io::validateCase(path);
    (void)io::loadCase(path, warnings);
}

std::string corrupted(const std::string& content, core::CounterRandom& random)
{
    std::string damaged = content;
    if (random.uniform() < 0.4) {
        damaged.resize(static_cast<std::size_t>(random.uniform() * static_cast<double>(content.size())));
    }
    const int flips = random.index(6);
    for (int i = 0; i < flips && !damaged.empty(); ++i) {
        const auto at = static_cast<std::size_t>(random.index(static_cast<int>(damaged.size())));
        damaged[at] = static_cast<char>(random.index(256));
    }
    return damaged;
}

std::vector<std::string> writeGoodFiles(const test::TemporaryFolder& folder)
{
    EXPECT_TRUE(io::writeVesselTree(twoBranches(), folder.file("tree.vtp")));
    EXPECT_TRUE(io::writeVesselTree(twoBranches(), folder.file("tree.csv")));
    EXPECT_TRUE(io::writeAngiogram(twoFrames(), folder.file("run.dcm")));
    EXPECT_TRUE(io::writePose({}, folder.file("pose.tfm")));
    EXPECT_TRUE(io::writePose({}, folder.file("pose.json")));
    core::Mask2d mask(40, 30);
    for (int x = 5; x < 35; ++x) {
        mask.at(x, 15) = 1;
    }
    EXPECT_TRUE(io::writePng(mask, folder.file("mask.png")));
    EXPECT_TRUE(io::writeCenterline2d({{{1, {{1.0, 2.0}, {3.0, 4.5}}, {1.0, 1.5}}}}, folder.file("curve.csv")));
    folder.write("legacy.vtk", legacyText);
    folder.write("tree.swc", swcText);
    core::Case good;
    good.vessels.file.path = folder.file("tree.csv");
    good.shown().imageFile.path = folder.file("run.dcm");
    good.shown().geometry.cameraOverride = core::ProjectionCamera{-1000, 1000, 11.5, 8.5, 24, 18};
    EXPECT_TRUE(io::saveCase(good, folder.file("good.angiopose")));
    return {"tree.vtp", "tree.csv",  "run.dcm",    "pose.tfm", "pose.json",
            "mask.png", "curve.csv", "legacy.vtk", "tree.swc", "good.angiopose"};
}

}   // namespace

TEST(DamagedFiles, NeverCrashAReader)
{
    const test::TemporaryFolder folder;
    core::CounterRandom random(20240521);
    for (const std::string& name : writeGoodFiles(folder)) {
        SCOPED_TRACE(name);
        const std::string good = test::readText(folder.file(name));
        for (int trial = 0; trial < 60; ++trial) {
            readAsEverything(folder.write("damaged/" + name, corrupted(good, random)));
        }
    }
}

TEST(DamagedFiles, CutShortNeverLoadAsAnImage)
{
    const test::TemporaryFolder folder;
    writeGoodFiles(folder);
    for (const char* name : {"run.dcm", "mask.png"}) {
        const std::string good = test::readText(folder.file(name));
        for (std::size_t size = 1; size + 1 < good.size(); size += 1 + good.size() / 100) {
            const std::string path = folder.write(std::string("cut/") + name, good.substr(0, size));
            const auto cut = io::readAngiogram(path);
            const bool isFirstFrame = cut && cut.value().frameCount() == 1 &&
                                      std::ranges::any_of(cut.value().warnings, [](const core::Message& said) {
                                          return said.is(io::messages::dicomFramesOther);
                                      });
            EXPECT_TRUE(!cut || isFirstFrame) << name << " of " << size << " bytes";
        }
    }
}

TEST(DamagedFiles, AreRefusedBeforeMemoryIsSpent)
{
    const test::TemporaryFolder folder;
    const std::string points =
        "# vtk DataFile Version 3.0\nlies\nASCII\nDATASET POLYDATA\nPOINTS 2000000000 float\n0 0 0\n";
    const auto legacy = io::readVesselTree(folder.write("points.vtk", points));
    ASSERT_FALSE(legacy);
    EXPECT_NE(legacy.error().message.text().find("POINTS"), std::string::npos);

    const std::string xml =
        "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"2000000000\" "
        "NumberOfLines=\"1\"></Piece></PolyData></VTKFile>";
    EXPECT_FALSE(io::readVesselTree(folder.write("points.vtp", xml)));
}

TEST(UnreadableInputs, SayWhatTheyAre)
{
    const test::TemporaryFolder folder;
    EXPECT_NE(io::readAngiogram(folder.file("absent.dcm")).error().message.text().find("does not exist"),
              std::string::npos);
    EXPECT_NE(io::readAngiogram(folder.write("empty.dcm", "")).error().message.text().find("empty"), std::string::npos);
    std::filesystem::create_directory(folder.file("folder.vtp"));
    EXPECT_NE(io::readVesselTree(folder.file("folder.vtp")).error().message.text().find("folder"), std::string::npos);
    EXPECT_NE(io::readVesselTree("/dev/zero").error().message.text().find("not a regular file"), std::string::npos);
}

/// The file system throws if a path cannot even be examined.
TEST(UnreadableInputs, MayBeOutOfReach)
{
    const test::TemporaryFolder folder;
    const std::string loop = folder.file("loop.nii");
    std::filesystem::create_symlink(loop, loop);
    for (const std::string& path : {loop, folder.file(std::string(300, 'x') + ".nii")}) {
        const auto kind = io::vesselInputKindOf(path);
        ASSERT_FALSE(kind);
        EXPECT_NE(kind.error().message.text().find(path), std::string::npos);
        EXPECT_FALSE(io::readVolume(path, {}, {}));
        EXPECT_FALSE(io::sha256OfVesselInput(path, {}));
    }
}
