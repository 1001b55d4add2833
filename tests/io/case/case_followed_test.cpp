#include "core/messages/messages.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/simulation/simulated_case.h"
#include "io/angiogram_file.h"
#include "io/case/tracked_deformations_file.h"
#include "tests/io/case/small_case.h"

#include <cmath>
#include <filesystem>
#include <functional>

using namespace angiopose;

namespace {

using core::TrackedRun;
using core::TrackedRunFrame;
using test::anyContains;
using Edit = std::function<void(nlohmann::json&)>;

core::RigidTransform moved(core::RigidTransform pose, double mm)
{
    pose.translation += Eigen::Vector3d(mm / 3.0, -0.1 * mm, mm);
    return pose;
}

/// A deformation that moves every point of the tree by a different displacement.
std::shared_ptr<const core::DeformableResult> deformationOf(const core::VesselTree& tree,
                                                            const core::RigidTransform& pose, double size)
{
    auto deformed = std::make_shared<core::DeformableResult>();
    deformed->verdict = core::DeformationVerdict::Deformed;
    deformed->cameraFromPatient = moved(pose, 0.7);
    deformed->viewPoses = {deformed->cameraFromPatient};
    deformed->largestMotionMm = size / 3.0;
    deformed->messages = {core::messages::deformationDepthUnknown()};
    double number = size;
    for (const core::VesselBranch& branch : tree.branches) {
        core::BranchMotion& motion = deformed->branches.emplace_back();
        motion.branchId = branch.id;
        motion.seenShare = 1.0 / 3.0;
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            number = std::remainder(-1.37 * number, 20.0);
            motion.displacementMm.emplace_back(number / 3.0, 0.1 * number, number);
            Eigen::Matrix3d covariance = Eigen::Vector3d(0.1 / 3.0, 0.001, 4.0).asDiagonal();
            covariance(0, 2) = covariance(2, 0) = 0.01 * number;
            motion.covariance.push_back(covariance);
        }
        core::roundMotion(motion);
    }
    return deformed;
}

/// Frames 0 to 3 tracked from frame 1: nothing traced in 0, deformed in 1 and 2, 3 deformed as 2.
TrackedRun richRun(const core::Case& session)
{
    const core::VesselTree& tree = *session.vessels.tree;
    std::vector<TrackedRunFrame> frames(4);
    for (int k = 0; k < 4; ++k) {
        TrackedRunFrame& frame = frames[static_cast<std::size_t>(k)];
        frame.frame = k;
        frame.tracked.cameraFromPatient = moved(session.shown().cameraFromPatient, k - 1.0);
        frame.tracked.score = 0.9 - 0.1 / 3.0 * k;
        frame.tracked.isTrustworthy = k == 1 || k == 2;
    }
    frames[0].problem = core::messages::trackingNeedsSeveralFrames();
    frames[2].tracked.isFromSearch = true;
    frames[1].deformed = deformationOf(tree, frames[1].tracked.cameraFromPatient, 3.0);
    frames[2].deformed = deformationOf(tree, frames[2].tracked.cameraFromPatient, 5.0);
    frames[3].deformed = core::transferDeformation(frames[2], frames[3].tracked.cameraFromPatient);
    frames[3].deformationSourceFrame = 2;
    return core::makeTrackedRun(1, std::move(frames));
}

/// A case with a run of four frames, the second of which is shown, and with tracked poses.
class CaseFollowed : public ::testing::Test {
protected:
    CaseFollowed()
    {
        core::DsaOptions dsa;
        dsa.width = dsa.height = 64;
        dsa.frameCount = 4;
        EXPECT_TRUE(io::writeAngiogram(core::simulateCase(3, {}, dsa).angiogram, small.path("in/run.dcm")));
        nlohmann::json json = small.json();
        json["angiogram"] = {{"image", {{"path", "in/run.dcm"}}}, {"frame", 1}};
        json["geometry"]["camera"]["width"] = json["geometry"]["camera"]["height"] = 64;
        auto loaded = small.load(json);
        EXPECT_TRUE(loaded) << loaded.error().message;
        session = std::move(loaded).value();
        session.shown().followed = richRun(session);
        EXPECT_TRUE(io::saveCase(session, path()));
    }

    std::string path() const { return small.path("saved.angiopose"); }
    std::string deformationsPath() const { return small.path("saved.bends.nrrd"); }

    core::Case afterEditing(const Edit& edit)
    {
        nlohmann::json json = nlohmann::json::parse(test::readText(path()));
        edit(json);
        small.folder().write("edited.angiopose", json.dump(1));
        return load(small.path("edited.angiopose"));
    }
    core::Case load(const std::string& from)
    {
        small.warnings.clear();
        return test::loadedFrom(from, small.warnings);
    }
    core::Case afterReplacingDeformation(const std::string& content)
    {
        small.folder().write("saved.bends.nrrd", content);
        return afterEditing([](nlohmann::json& json) { json["followed"]["bends"].erase("sha256"); });
    }

    void expectPosesWithoutDeformation(const core::Case& read, const std::string& why)
    {
        const auto& frames = core::framesOf(read.shown().followed);
        ASSERT_EQ(frames.size(), 4U) << why;
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(frames[k].tracked.cameraFromPatient.matrix(),
                      core::framesOf(session.shown().followed)[k].tracked.cameraFromPatient.matrix());
            EXPECT_FALSE(frames[k].deformed) << why;
            EXPECT_FALSE(frames[k].deformationSourceFrame) << why;
        }
        EXPECT_TRUE(anyContains(small.warnings, "but without deformation: ")) << why;
        EXPECT_TRUE(anyContains(small.warnings, why)) << small.warnings.front().text();
    }

    test::SmallCase small;
    core::Case session;
};

void expectSame(const core::DeformableResult& a, const core::DeformableResult& b)
{
    EXPECT_EQ(a.verdict, b.verdict);
    EXPECT_EQ(a.cameraFromPatient.matrix(), b.cameraFromPatient.matrix());
    EXPECT_EQ(a.viewPoses.front().matrix(), b.viewPoses.front().matrix());
    EXPECT_EQ(a.largestMotionMm, b.largestMotionMm);
    EXPECT_EQ(a.messages, b.messages);
    ASSERT_EQ(a.branches.size(), b.branches.size());
    for (std::size_t k = 0; k < a.branches.size(); ++k) {
        EXPECT_EQ(a.branches[k].branchId, b.branches[k].branchId);
        EXPECT_EQ(a.branches[k].seenShare, b.branches[k].seenShare);
        EXPECT_EQ(a.branches[k].displacementMm, b.branches[k].displacementMm);
        EXPECT_EQ(a.branches[k].covariance, b.branches[k].covariance);
    }
}

TEST_F(CaseFollowed, ReopensWithEveryBit)
{
    const core::Case again = load(path());
    EXPECT_TRUE(io::validateCase(path()).value().empty());
    const TrackedRun& run = again.shown().followed;
    const auto& frames = core::framesOf(run);
    const auto& kept = core::framesOf(session.shown().followed);
    EXPECT_EQ(run.startFrame, 1);
    ASSERT_EQ(frames.size(), kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        EXPECT_EQ(frames[k].frame, kept[k].frame);
        EXPECT_EQ(frames[k].tracked.cameraFromPatient.matrix(), kept[k].tracked.cameraFromPatient.matrix());
        EXPECT_EQ(frames[k].tracked.score, kept[k].tracked.score);
        EXPECT_EQ(frames[k].tracked.isFromSearch, kept[k].tracked.isFromSearch);
        EXPECT_EQ(frames[k].tracked.isTrustworthy, kept[k].tracked.isTrustworthy);
        EXPECT_EQ(frames[k].problem, kept[k].problem);
        EXPECT_EQ(frames[k].deformationSourceFrame, kept[k].deformationSourceFrame);
        ASSERT_EQ(frames[k].deformed == nullptr, kept[k].deformed == nullptr) << k;
        if (kept[k].deformed) {
            expectSame(*frames[k].deformed, *kept[k].deformed);
        }
    }
    ASSERT_TRUE(io::saveCase(again, small.path("again.angiopose")));
    EXPECT_EQ(test::readText(small.path("again.bends.nrrd")), test::readText(deformationsPath()));
}

TEST_F(CaseFollowed, OfRigidVesselsNeedsNoFileOfDeformation)
{
    std::vector<TrackedRunFrame> rigid = core::framesOf(session.shown().followed);
    for (TrackedRunFrame& each : rigid) {
        each.deformed.reset();
        each.deformationSourceFrame.reset();
    }
    session.shown().followed = core::makeTrackedRun(1, std::move(rigid));
    ASSERT_TRUE(io::saveCase(session, small.path("rigid.angiopose")));
    EXPECT_FALSE(std::filesystem::exists(small.path("rigid.bends.nrrd")));
    EXPECT_EQ(core::framesOf(load(small.path("rigid.angiopose")).shown().followed).size(), 4U);
    EXPECT_FALSE(anyContains(small.warnings, "without deformation"));
}

TEST_F(CaseFollowed, IsLeftOutBesideOtherInputs)
{
    const std::vector<std::pair<std::string, Edit>> edits{
        {"the geometry", [](auto& json) { json["geometry"]["camera"]["fx"] = -2001; }},
        {"the traced curves", [](auto& json) { json["angiogram"]["trace"]["sensitivity"] = 1.25; }},
        {"the excluded branches", [](auto& json) { json["vessel"]["excludedBranches"] = {2}; }},
        {"the vessels", [](auto& json) { json["vessel"]["unitMm"] = 1.5; }},
    };
    for (const auto& [what, edit] : edits) {
        EXPECT_FALSE(afterEditing(edit).shown().followed.frames) << what;
        EXPECT_TRUE(anyContains(small.warnings, "have changed since it was computed: " + what)) << what;
    }
    small.folder().write("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n21,1,0,1\n10,0,0,2\n10,8,0,2\n");
    EXPECT_FALSE(load(path()).shown().followed.frames);
    EXPECT_TRUE(anyContains(small.warnings, "have changed since it was computed. Register again."));
}

TEST_F(CaseFollowed, IsLeftOutWhereItFitsNeitherPoseNorRun)
{
    const std::vector<Edit> edits{
        [](auto& json) { json["pose"]["current"]["cameraFromPatient"][0][3] = 7.0; },
        [](auto& json) { json["followed"]["frames"][3]["frame"] = 4; },
        [](auto& json) { json["followed"]["frames"][3]["frame"] = 2; },
    };
    for (const Edit& edit : edits) {
        EXPECT_FALSE(afterEditing(edit).shown().followed.frames);
        EXPECT_TRUE(anyContains(small.warnings, "do not match the run or the pose of the case"));
    }
}

TEST_F(CaseFollowed, KeepsItsPosesWithoutTheFileOfDeformation)
{
    const std::string whole = test::readText(deformationsPath());
    small.folder().write("saved.bends.nrrd", whole.substr(0, whole.size() - 1) + "x");
    expectPosesWithoutDeformation(load(path()), "has changed since the case was saved");
    expectPosesWithoutDeformation(afterReplacingDeformation(whole.substr(0, whole.size() - 4)), "damaged or truncated");
    expectPosesWithoutDeformation(afterReplacingDeformation(whole + "more"), "damaged or truncated");
    std::string endless = whole;
    endless.replace(whole.size() - 4, 4, std::string("\0\0\x80\x7f", 4));   // infinity
    expectPosesWithoutDeformation(afterReplacingDeformation(endless), "damaged or truncated");
    std::string others = whole;
    others.replace(whole.find("sizes: 9 5 2"), 12, "sizes: 9 5 3");
    expectPosesWithoutDeformation(afterReplacingDeformation(others), "belong to different vessels or frames");
    expectPosesWithoutDeformation(afterReplacingDeformation("a letter"), "not a deformation file");
    small.folder().write("saved.bends.nrrd", whole);
    expectPosesWithoutDeformation(afterEditing([](auto& json) { json["followed"].erase("bends"); }),
                                  "specifies no deformation file");
    expectPosesWithoutDeformation(
        afterEditing([](auto& json) { json["followed"]["frames"][1]["deformable"]["perBranch"][0]["branch"] = 9; }),
        "belong to different vessels or frames");
    std::filesystem::remove(deformationsPath());
    expectPosesWithoutDeformation(load(path()), "saved.bends.nrrd");
}

TEST_F(CaseFollowed, ReplacesItsOwnFileAndNoOther)
{
    const std::string first = test::readText(deformationsPath());
    std::vector<TrackedRunFrame> frames = core::framesOf(session.shown().followed);
    frames[1].deformed = deformationOf(*session.vessels.tree, frames[1].tracked.cameraFromPatient, 9.0);
    session.shown().followed = core::makeTrackedRun(1, std::move(frames));
    ASSERT_TRUE(io::saveCase(session, path()));
    EXPECT_NE(test::readText(deformationsPath()), first);
    EXPECT_FALSE(std::filesystem::exists(small.path("saved.bends-2.nrrd")));

    small.folder().write("other.bends.nrrd", "somebody else's");
    ASSERT_TRUE(io::saveCase(session, small.path("other.angiopose")));
    EXPECT_EQ(test::readText(small.path("other.bends.nrrd")), "somebody else's");
    EXPECT_TRUE(core::framesOf(load(small.path("other.angiopose")).shown().followed)[1].deformed);
}

TEST_F(CaseFollowed, IsKeptForEveryView)
{
    session.views.push_back(session.shown());
    session.views.front().followed = {};
    ASSERT_TRUE(io::saveCase(session, small.path("two.angiopose")));
    EXPECT_TRUE(std::filesystem::exists(small.path("two.view-2.bends.nrrd")));
    const core::Case again = load(small.path("two.angiopose"));
    ASSERT_EQ(again.views.size(), 2U);
    EXPECT_FALSE(again.views[0].followed.frames);
    ASSERT_EQ(core::framesOf(again.views[1].followed).size(), 4U);
    EXPECT_TRUE(core::framesOf(again.views[1].followed)[3].deformed);
}

TEST_F(CaseFollowed, OfALongRunIsNoLargeCase)
{
    auto tree = std::make_shared<core::VesselTree>();
    for (int id = 1; id <= 40; ++id) {
        core::VesselBranch& branch = tree->branches.emplace_back();
        branch.id = id;
        for (int i = 0; i < 50; ++i) {
            branch.pointsInPatient.emplace_back(i, 2.0 * id, 0.1 * i);
        }
    }
    ASSERT_EQ(tree->pointCount(), 2000U);
    session.vessels.tree = tree;
    session.vessels.isTreeEdited = true;
    std::vector<TrackedRunFrame> frames(60);
    for (int k = 0; k < 60; ++k) {
        TrackedRunFrame& frame = frames[static_cast<std::size_t>(k)];
        frame.frame = k;
        frame.tracked.cameraFromPatient = moved(session.shown().cameraFromPatient, k - 1.0);
        frame.deformed = deformationOf(*tree, frame.tracked.cameraFromPatient, 0.1 * k + 0.3);
    }
    const auto sizeOf = [](const std::string& of) { return static_cast<double>(std::filesystem::file_size(of)); };
    session.shown().followed = {};
    ASSERT_TRUE(io::saveCase(session, small.path("before.angiopose")));
    session.shown().followed = core::makeTrackedRun(1, std::move(frames));
    ASSERT_TRUE(io::saveCase(session, small.path("long.angiopose")));
    const double caseMb = 1e-6 * (sizeOf(small.path("long.angiopose")) - sizeOf(small.path("before.angiopose")));
    const double deformationsMb = 1e-6 * sizeOf(small.path("long.bends.nrrd"));
    std::printf("60 frames of 2000 points: %.2f MB in the case, %.2f MB beside it\n", caseMb, deformationsMb);
    EXPECT_LT(caseMb, 0.5);
    EXPECT_LT(deformationsMb, 4.5);
}

}   // namespace
