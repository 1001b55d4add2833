#include "tests/app/open_window.h"

#include "core/case/case.h"
#include "core/vessel/vessel_tree.h"

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

/// A point on the vessels far from their centroid, and its position in the angiogram.
struct Place {
    Eigen::Vector3d pointInPatient;
    QPoint at;
};

Place farPlace(OpenWindow& w)
{
    const Eigen::Vector3d centroid = core::centroidInPatient(*w.current().vessels.tree);
    Place place;
    double farthestMm = 0.0;
    for (const core::VesselNode& node : core::findNodes(*w.current().vessels.tree)) {
        const auto at = w.window.angiogramView().positionOf(node.pointInPatient);
        const double mm = (node.pointInPatient - centroid).norm();
        if (at && w.window.angiogramView().rect().adjusted(30, 60, -30, -60).contains(at->toPoint()) &&
            mm > farthestMm) {
            farthestMm = mm;
            place = {node.pointInPatient, at->toPoint()};
        }
    }
    EXPECT_GT(farthestMm, 5.0);
    return place;
}

void pickAt(OpenWindow& w, const Place& place)
{
    w.press(Qt::Key_N, Qt::ShiftModifier);
    EXPECT_TRUE(w.window.actions()[ui::Command::PickPivot]->isChecked());
    QTest::mouseClick(&w.window.angiogramView(), Qt::LeftButton, Qt::NoModifier, place.at);
}

TEST(WindowPivot, PickedByClickTheVesselsTurnAboutItAndNotTheCentroid)
{
    SampleWindow w;
    const Place place = farPlace(w);
    pickAt(w, place);

    ASSERT_TRUE(w.current().vessels.pickedPivotInPatient);
    EXPECT_LT((*w.current().vessels.pickedPivotInPatient - place.pointInPatient).norm(), 1e-9)
        << "the bifurcation itself";
    EXPECT_FALSE(w.window.actions()[ui::Command::PickPivot]->isChecked()) << "one click, one pivot";
    EXPECT_EQ(w.window.angiogramView().pivotInPatient(), place.pointInPatient) << "the handles sit there";

    const core::RigidTransform before = w.current().shown().cameraFromPatient;
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right, Qt::AltModifier | Qt::ShiftModifier);
    const core::RigidTransform after = w.current().shown().cameraFromPatient;
    EXPECT_GT(core::angleBetween(before.rotation, after.rotation), 0.1);
    EXPECT_LT((after * place.pointInPatient - before * place.pointInPatient).norm(), 1e-9);
    const Eigen::Vector3d centroid = core::centroidInPatient(*w.current().vessels.tree);
    EXPECT_GT((after * centroid - before * centroid).norm(), 0.5);
    const auto offset = w.controller.pose().currentOffset();
    EXPECT_NEAR(offset->laoRaoDeg, 10.0, 1e-9);
    EXPECT_NEAR(offset->rightMm, 0.0, 1e-9) << "shifts are those of the pivot";
}

TEST(WindowPivot, IsUndoneClearedAndPickedByKeys)
{
    SampleWindow w;
    pickAt(w, farPlace(w));
    ASSERT_TRUE(w.current().vessels.pickedPivotInPatient);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().vessels.pickedPivotInPatient);
    EXPECT_FALSE(w.window.actions()[ui::Command::CentroidPivot]->isEnabled());

    w.press(Qt::Key_N, Qt::ShiftModifier);
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Right);
    w.press(Qt::Key_Return);
    const auto nodes = core::findNodes(*w.current().vessels.tree);
    ASSERT_TRUE(w.current().vessels.pickedPivotInPatient);
    EXPECT_EQ(*w.current().vessels.pickedPivotInPatient, nodes[1].pointInPatient);

    w.press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(w.current().vessels.pickedPivotInPatient);
    EXPECT_EQ(w.window.angiogramView().pivotInPatient(), core::centroidInPatient(*w.current().vessels.tree));
}

TEST(WindowPivot, ALockedShiftIsThatOfThePivotInARunToo)
{
    SampleWindow w;
    const Place place = farPlace(w);
    pickAt(w, place);
    ui::PoseLocks locks{};
    locks[static_cast<std::size_t>(ui::PoseAxis::Right)] = true;
    locks[static_cast<std::size_t>(ui::PoseAxis::Up)] = true;
    w.controller.pose().setLocks(locks);
    const core::RigidTransform before = w.current().shown().cameraFromPatient;

    w.registerVessels();

    ASSERT_TRUE(w.current().shown().result);
    const core::RigidTransform after = w.current().shown().cameraFromPatient;
    EXPECT_GT(core::angleBetween(before.rotation, after.rotation), 1e-3);
    EXPECT_LT((after * place.pointInPatient - before * place.pointInPatient).head<2>().norm(), 1e-6);
}

TEST(WindowPivot, IsSeenInBothViewsAndNotOnlyByColor)
{
    SampleWindow w;
    const Place place = farPlace(w);
    const auto picture = [&w, &place] {
        return w.window.angiogramView().grab(QRect(place.at - QPoint(10, 20), QSize(60, 40))).toImage();
    };
    const auto picture3d = [&w] { return w.window.treeView().grab().toImage(); };
    QApplication::processEvents();
    const QImage before = picture(), before3d = picture3d();
    pickAt(w, place);
    QApplication::processEvents();
    EXPECT_NE(picture(), before);
    EXPECT_NE(picture3d(), before3d);
}

}   // namespace
}   // namespace angiopose::app
