#include "app/showing/pose_preview.h"

#include <gtest/gtest.h>
#include <QSignalSpy>

namespace angiopose::app {
namespace {

core::RigidTransform atDepth(double mm)
{
    core::RigidTransform pose;
    pose.translation.z() = mm;
    return pose;
}

TEST(PosePreview, ShowsTheDocumentsPoseUntilSomebodyShowsAnother)
{
    const CaseDocument document;
    PosePreview preview(document);
    EXPECT_FALSE(preview.shown());
    EXPECT_EQ(&preview.pose(), &document.current().shown().cameraFromPatient);

    preview.show(PreviewSource::Swing, atDepth(700.0), ResidualColors::Hidden);
    EXPECT_EQ(preview.shown(), PreviewSource::Swing);
    EXPECT_EQ(preview.pose().translation.z(), 700.0);
    EXPECT_EQ(preview.colors(), ResidualColors::Hidden);

    preview.end(PreviewSource::Swing);
    EXPECT_FALSE(preview.shown());
    EXPECT_EQ(&preview.pose(), &document.current().shown().cameraFromPatient);
    EXPECT_EQ(preview.colors(), ResidualColors::Visible);
}

TEST(PosePreview, NobodyEndsWhatAnotherShows)
{
    const CaseDocument document;
    PosePreview preview(document);
    preview.show(PreviewSource::Snapshot, atDepth(700.0), ResidualColors::Hidden);
    preview.show(PreviewSource::Drag, atDepth(800.0), ResidualColors::Visible);
    const QSignalSpy changed(&preview, &PosePreview::changed);
    preview.end(PreviewSource::Snapshot);
    EXPECT_EQ(preview.shown(), PreviewSource::Drag);
    EXPECT_EQ(preview.pose().translation.z(), 800.0);
    EXPECT_EQ(changed.count(), 0);
}

TEST(PosePreview, TellsWhomAnotherTakesThePlaceOf)
{
    const CaseDocument document;
    PosePreview preview(document);
    std::vector<PreviewSource> gone;
    QObject::connect(&preview, &PosePreview::replaced, [&](PreviewSource whose) {
        EXPECT_NE(preview.shown(), whose);
        gone.push_back(whose);
        preview.end(whose);   // as owners do when their preview is replaced
    });
    preview.show(PreviewSource::Solution, atDepth(700.0), ResidualColors::Hidden);
    preview.show(PreviewSource::Solution, atDepth(710.0), ResidualColors::Hidden);
    EXPECT_TRUE(gone.empty());
    preview.show(PreviewSource::Run, atDepth(800.0), ResidualColors::Visible);
    EXPECT_EQ(gone, std::vector{PreviewSource::Solution});
    EXPECT_EQ(preview.shown(), PreviewSource::Run);
}

/// Two views, the second rotated by 90° and 20 mm closer.
core::Case twoPoses()
{
    core::Case values;
    values.views.resize(2);
    values.views[0].cameraFromPatient = atDepth(700.0);
    values.views[1].cameraFromPatient = {core::expSo3({0.0, 1.5707963267948966, 0.0}), {0.0, 0.0, 680.0}};
    values.views[1].initialCameraFromPatient = atDepth(650.0);
    return values;
}

TEST(PosePreview, TakesTheOtherViewsAlong)
{
    CaseDocument document;
    document.replace(twoPoses(), {});
    PosePreview preview(document);
    const core::RigidTransform own = document.current().views[1].cameraFromPatient;
    EXPECT_EQ(preview.poseOfView(1).matrix(), own.matrix());
    core::RigidTransform moved = atDepth(700.0);
    moved.translation.x() = 6.0;
    preview.show(PreviewSource::Drag, moved, ResidualColors::Visible);
    EXPECT_EQ(preview.poseOfView(0).matrix(), moved.matrix());
    // 6 mm across the first view is 6 mm along the ray of the second
    const Eigen::Vector3d way = preview.poseOfView(1).translation - own.translation;
    EXPECT_NEAR(std::abs(way.z()), 6.0, 1e-9);
    EXPECT_NEAR(way.head<2>().norm(), 0.0, 1e-9);
    EXPECT_EQ(preview.poseOfView(1).rotation, own.rotation);

    preview.show(PreviewSource::Start, atDepth(720.0), ResidualColors::Hidden);
    EXPECT_EQ(preview.poseOfView(1).matrix(), atDepth(650.0).matrix()) << "each has its own start";
    preview.show(PreviewSource::Frame, moved, ResidualColors::Hidden);
    EXPECT_EQ(preview.poseOfView(1).matrix(), own.matrix()) << "the heart moves in one run only";
}

TEST(PosePreview, LeavesViewsAloneThatDoNotMoveTogether)
{
    CaseDocument document;
    document.replace(twoPoses(), {});
    PosePreview preview(document);
    const QSignalSpy changed(&preview, &PosePreview::changed);
    preview.setMovesAllViews(false);
    preview.setMovesAllViews(false);
    EXPECT_EQ(changed.count(), 1);
    preview.show(PreviewSource::Drag, atDepth(720.0), ResidualColors::Visible);
    EXPECT_EQ(preview.poseOfView(1).matrix(), document.current().views[1].cameraFromPatient.matrix());
}

}   // namespace
}   // namespace angiopose::app
