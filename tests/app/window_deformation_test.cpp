#include "app/document/edit_case.h"
#include "core/registration/deformable/deformed_tree.h"
#include "io/case/case_file.h"
#include "io/vessel_tree_file.h"
#include "tests/app/open_window.h"
#include "tests/support/deformed_case.h"
#include "tests/support/temporary_folder.h"
#include "ui/actions/window_actions.h"

namespace angiopose::app {
namespace {

using test::OpenWindow;

constexpr double maxMm = 4.0;

/// The sample with deformed vessels, at a pose away from the initial pose.
struct DeformedWindow : OpenWindow {
    DeformedWindow()
    {
        openSample();
        core::Case moved = current();
        moved.shown().cameraFromPatient.translation.x() += 2.0;   // away from the initial pose
        controller.document().replace(test::withDeformedVessels(std::move(moved), maxMm), {});
        waitForJudgement();
    }

    const ui::OverlayContent& content() { return window.angiogramView().scene().content(); }
    const core::DeformableResult& deformed() { return *current().shown().result->deformed; }

    /// Largest distance between the drawn tree and another tree, mm.
    double farthestFrom(const core::VesselTree& tree)
    {
        double mm = 0.0;
        for (std::size_t b = 0; b < tree.branches.size(); ++b) {
            for (std::size_t i = 0; i < tree.branches[b].pointsInPatient.size(); ++i) {
                mm = std::max(
                    mm, (content().tree.branches[b].pointsInPatient[i] - tree.branches[b].pointsInPatient[i]).norm());
            }
        }
        return mm;
    }
    bool isRigidDrawn() { return farthestFrom(*current().vessels.tree) == 0.0; }
    bool isDeformedDrawn() { return farthestFrom(core::deformedTree(*current().vessels.tree, deformed())) < 1e-6; }
};

TEST(WindowDeformed, DrawsTheDeformedVesselsAndComparesByOneKey)
{
    DeformedWindow w;
    EXPECT_TRUE(w.isDeformedDrawn());
    EXPECT_NEAR(w.farthestFrom(*w.current().vessels.tree), maxMm, 0.01);
    w.press(Qt::Key_Y, Qt::ShiftModifier);
    EXPECT_TRUE(w.isRigidDrawn());
    w.press(Qt::Key_Y, Qt::ShiftModifier);
    EXPECT_TRUE(w.isDeformedDrawn());
    EXPECT_FALSE(w.history().canUndo()) << "how it is shown is no edit";
}

TEST(WindowDeformed, DrawsTheDeformationThatFollowingFoundForAFrame)
{
    DeformedWindow w;
    const core::VesselTree& tree = *w.current().vessels.tree;
    auto ofFrame = std::make_shared<core::DeformableResult>(w.deformed());
    core::RigidTransform pose = w.current().shown().cameraFromPatient;
    pose.translation.y() += 3.0;
    ofFrame->cameraFromPatient = pose;
    for (core::BranchMotion& motion : ofFrame->branches) {
        for (Eigen::Vector3d& displacement : motion.displacementMm) {
            displacement *= 0.5;
        }
        core::roundMotion(motion);
    }
    core::TrackedRunFrame itself;
    itself.frame = w.current().shown().frame;
    itself.tracked.cameraFromPatient = w.current().shown().cameraFromPatient;
    core::TrackedRunFrame next{itself.frame + 1, {pose, 0.9, false, true, {}}, {}, ofFrame, {}};
    w.controller.document().push(std::make_unique<SetTrackedPoses>(
        w.controller.document(), SetTrackedPoses::Values{core::makeTrackedRun(itself.frame, {itself, next})},
        [] { return QStringLiteral("Follow"); }));
    EXPECT_TRUE(w.isDeformedDrawn()) << "the frame itself as it was";
    w.press(Qt::Key_Down);
    ASSERT_EQ(w.current().shown().frame, next.frame);
    EXPECT_LT(w.farthestFrom(core::deformedTreeAt(tree, *ofFrame, pose)), 1e-6);
    w.press(Qt::Key_Y, Qt::ShiftModifier);
    EXPECT_TRUE(w.isRigidDrawn());
    w.press(Qt::Key_Y, Qt::ShiftModifier);

    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    EXPECT_TRUE(w.isRigidDrawn()) << "nothing is known of that pose";
    w.press(Qt::Key_N);
    w.controller.document().undo();
    EXPECT_LT(w.farthestFrom(core::deformedTreeAt(tree, *ofFrame, pose)), 1e-6);

    const test::TemporaryFolder folder;
    ASSERT_TRUE(io::saveCase(w.current(), folder.file("followed.angiopose")));
    {
        DeformedWindow again;
        again.drop({QString::fromStdString(folder.file("followed.angiopose"))});
        again.waitForJudgement();
        ASSERT_EQ(again.current().shown().frame, next.frame);
        EXPECT_LT(again.farthestFrom(core::deformedTreeAt(tree, *ofFrame, pose)), 1e-6) << "as it was left";
        again.press(Qt::Key_Up);
        EXPECT_TRUE(again.isRigidDrawn()) << "as followed there";
        again.press(Qt::Key_Down);
        EXPECT_LT(again.farthestFrom(core::deformedTreeAt(tree, *ofFrame, pose)), 1e-6);
    }
}

TEST(WindowDeformed, DrawsThemAtNoOtherPose)
{
    DeformedWindow w;
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    ASSERT_TRUE(test::waitFor([&w] { return w.history().canUndo(); }));
    EXPECT_FALSE(w.current().shown().result);
    EXPECT_TRUE(w.isRigidDrawn());
    w.press(Qt::Key_N);
    w.controller.document().undo();
    EXPECT_TRUE(w.isDeformedDrawn());
    w.controller.document().redo();
    EXPECT_TRUE(w.isRigidDrawn());
    w.controller.document().undo();
    w.press(Qt::Key_F);   // shows the initial pose temporarily
    EXPECT_TRUE(w.isRigidDrawn());
    w.press(Qt::Key_F);
    EXPECT_TRUE(w.isDeformedDrawn());
}

TEST(WindowDeformed, ColorsByHowFarTheyMoved)
{
    DeformedWindow w;
    const auto residuals = w.content().residualPx;
    w.press(Qt::Key_M, Qt::ShiftModifier);
    ASSERT_FALSE(w.content().residualPx.empty());
    EXPECT_EQ(w.content().scaleMaximumPx, 5.0);   // mm: the next round number above 4
    const auto& branch = w.current().vessels.tree->branches.front();
    const std::vector<double>& moved = w.content().residualPx.at(branch.id);
    ASSERT_EQ(moved.size(), branch.pointsInPatient.size());
    EXPECT_NEAR(moved.front(), 0.0, 1e-3);
    EXPECT_NEAR(moved.back(), maxMm, 0.2);   // perpendicular to the ray, which is not exactly z
    w.press(Qt::Key_M, Qt::ShiftModifier);
    EXPECT_EQ(w.content().residualPx, residuals);
}

TEST(WindowDeformed, ReopensThemAsTheyWere)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("bent.angiopose");
    core::VesselTree drawn;
    {
        DeformedWindow w;
        drawn = w.content().tree;
        ASSERT_TRUE(io::saveCase(w.current(), path));
    }
    OpenWindow again;
    again.drop({QString::fromStdString(path)});
    again.waitForJudgement();
    const core::VesselTree& reopened = again.window.angiogramView().scene().content().tree;
    ASSERT_EQ(reopened.branches.size(), drawn.branches.size());
    for (std::size_t b = 0; b < drawn.branches.size(); ++b) {
        EXPECT_EQ(reopened.branches[b].pointsInPatient, drawn.branches[b].pointsInPatient);
    }
}

TEST(WindowDeformed, ExportsTreeAndMotion)
{
    const test::TemporaryFolder folder;
    DeformedWindow w;
    for (const char* const name : {"bent.vtp", "motion.csv"}) {
        w.window.actions()[ui::Command::ExportDeformed]->trigger();
        w.saveAs(QString::fromStdString(folder.file(name)));
        EXPECT_TRUE(test::waitFor([&w] { return !w.window.findChild<QFileDialog*>(); }));
    }
    const auto deformed = io::readVesselTree(folder.file("bent.vtp"));
    const auto undeformed = io::readVesselTree(folder.file("motion.csv"));
    ASSERT_TRUE(deformed) << deformed.error().message;
    ASSERT_TRUE(undeformed) << undeformed.error().message;
    const Eigen::Vector3d moved = deformed.value().branches.front().pointsInPatient.back() -
                                  undeformed.value().branches.front().pointsInPatient.back();
    EXPECT_NEAR(moved.norm(), maxMm, 0.01);
}

}   // namespace
}   // namespace angiopose::app
