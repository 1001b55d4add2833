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

    preview.show(PreviewOf::Swing, atDepth(700.0), ResidualColors::Hidden);
    EXPECT_EQ(preview.shown(), PreviewOf::Swing);
    EXPECT_EQ(preview.pose().translation.z(), 700.0);
    EXPECT_EQ(preview.colors(), ResidualColors::Hidden);

    preview.end(PreviewOf::Swing);
    EXPECT_FALSE(preview.shown());
    EXPECT_EQ(&preview.pose(), &document.current().shown().cameraFromPatient);
    EXPECT_EQ(preview.colors(), ResidualColors::Kept);
}

TEST(PosePreview, NobodyEndsWhatAnotherShows)
{
    const CaseDocument document;
    PosePreview preview(document);
    preview.show(PreviewOf::Snapshot, atDepth(700.0), ResidualColors::Hidden);
    preview.show(PreviewOf::Drag, atDepth(800.0), ResidualColors::Kept);
    const QSignalSpy changed(&preview, &PosePreview::changed);
    preview.end(PreviewOf::Snapshot);
    EXPECT_EQ(preview.shown(), PreviewOf::Drag);
    EXPECT_EQ(preview.pose().translation.z(), 800.0);
    EXPECT_EQ(changed.count(), 0);
}

TEST(PosePreview, TellsWhomAnotherTakesThePlaceOf)
{
    const CaseDocument document;
    PosePreview preview(document);
    std::vector<PreviewOf> gone;
    QObject::connect(&preview, &PosePreview::gaveWay, [&](PreviewOf whose) {
        EXPECT_NE(preview.shown(), whose);
        gone.push_back(whose);
        preview.end(whose);   // as those do that show themselves ended
    });
    preview.show(PreviewOf::Solution, atDepth(700.0), ResidualColors::Hidden);
    preview.show(PreviewOf::Solution, atDepth(710.0), ResidualColors::Hidden);
    EXPECT_TRUE(gone.empty());
    preview.show(PreviewOf::Run, atDepth(800.0), ResidualColors::Kept);
    EXPECT_EQ(gone, std::vector{PreviewOf::Solution});
    EXPECT_EQ(preview.shown(), PreviewOf::Run);
}

}   // namespace
}   // namespace angiopose::app
