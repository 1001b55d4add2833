#include "app/document/edit_case.h"
#include "app/report/report_measures.h"
#include "core/measuring/measure_image.h"
#include "io/measurement_table.h"
#include "tests/app/scan_window.h"
#include "ui/panels/measure_panel.h"

#include <QTreeWidget>

namespace angiopose::app {
namespace {

using core::BodyPlane;

class WindowSliceMeasure : public test::ScanWindow {
protected:
    const std::vector<core::SliceMeasurement>& measurements() { return w.current().vessels.measurements; }
    QTreeWidget& list() { return *w.window.measure().findChild<QTreeWidget*>(); }
    void dragLength(BodyPlane plane, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
        ui::SliceView& v = view(plane);
        QTest::mousePress(&v, Qt::LeftButton, Qt::NoModifier, placeOf(plane, from));
        QTest::mouseMove(&v, (placeOf(plane, from) + placeOf(plane, to)) / 2);
        QTest::mouseMove(&v, placeOf(plane, to));
        QTest::mouseRelease(&v, Qt::LeftButton, Qt::NoModifier, placeOf(plane, to));
    }
};

TEST_F(WindowSliceMeasure, ALengthIsDrawnListedAndUndone)
{
    const Eigen::Vector3d before = model().crosshair();
    const int steps = w.history().count();
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_D, Qt::ShiftModifier);
    ASSERT_TRUE(w.window.actions()[ui::Command::MeasureLength]->isChecked());
    const double z = view(BodyPlane::Axial).grid().firstInPatient.z();
    dragLength(BodyPlane::Axial, {-10, 0, z}, {10, 5, z});
    ASSERT_EQ(measurements().size(), 1U);
    EXPECT_EQ(w.history().count(), steps + 1);
    EXPECT_EQ(model().crosshair(), before) << "measuring moves no cross-hair";
    EXPECT_NEAR(core::valueOf(measurements()[0]).value().value, std::hypot(20.0, 5.0),
                2.0 / view(BodyPlane::Axial).pxPerMm());
    ASSERT_EQ(list().topLevelItemCount(), 1);
    EXPECT_TRUE(list().topLevelItem(0)->text(1).contains(QStringLiteral("in the scan")));
    EXPECT_TRUE(list().topLevelItem(0)->toolTip(0).contains(QStringLiteral("Scan voxel size: 1.000 mm")));
    ASSERT_EQ(model().measurementData().size(), 1U);

    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(measurements().empty());
    EXPECT_TRUE(model().measurementData().empty());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(measurements().size(), 1U);
}

TEST_F(WindowSliceMeasure, AMeasurementMayGoWhileItsPointIsHeld)
{
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_D, Qt::ShiftModifier);
    const double z = view(BodyPlane::Axial).grid().firstInPatient.z();
    dragLength(BodyPlane::Axial, {-10, 0, z}, {10, 5, z});
    ui::SliceView& axial = view(BodyPlane::Axial);
    QTest::mousePress(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {10, 5, z}));
    QTest::mouseMove(&axial, placeOf(BodyPlane::Axial, {12, 9, z}));
    QTest::keyClick(&axial, Qt::Key_Z, Qt::ControlModifier);
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {12, 9, z}));
    EXPECT_TRUE(measurements().empty());
}

TEST_F(WindowSliceMeasure, APointStaysInItsSlice)
{
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_D, Qt::ShiftModifier);
    const double z = view(BodyPlane::Axial).grid().firstInPatient.z();
    dragLength(BodyPlane::Axial, {-10, 0, z}, {10, 5, z});
    const auto drawn = measurements();
    ui::SliceView& axial = view(BodyPlane::Axial);
    QTest::mousePress(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {10, 5, z}));
    QTest::mouseMove(&axial, placeOf(BodyPlane::Axial, {12, 9, z}));
    wheel(BodyPlane::Axial, 2, Qt::NoModifier);
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {12, 9, z}));
    EXPECT_EQ(measurements(), drawn);
}

TEST_F(WindowSliceMeasure, DeleteOverSlicesTakesNoneOfTheImage)
{
    core::ImageMeasurement inImage;
    inImage.kind = core::MeasurementKind::Length;
    inImage.pixels = {{10, 10}, {20, 20}};
    w.controller.document().push(std::make_unique<ChangeMeasurements>(
        w.controller.document(),
        ChangeMeasurements::Values{std::vector<core::ImageMeasurement>{inImage}, std::vector<core::SliceMeasurement>{}},
        [] { return QString(); }));
    ASSERT_EQ(w.current().shown().measurements.size(), 1U);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_D, Qt::ShiftModifier);
    ASSERT_EQ(w.current().shown().measurements.size(), 1U);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Delete);
    EXPECT_EQ(w.current().shown().measurements.size(), 1U);
}

TEST_F(WindowSliceMeasure, AClickInTheListShowsItsSlice)
{
    QTest::keyClick(&view(BodyPlane::Coronal), Qt::Key_D, Qt::ShiftModifier);
    model().setCrosshair({0, -8, 30});
    QApplication::processEvents();
    dragLength(BodyPlane::Coronal, {-10, -8, 20}, {10, -8, 20});
    ASSERT_EQ(measurements().size(), 1U);
    EXPECT_EQ(measurements()[0].plane, BodyPlane::Coronal);
    model().setCrosshair({0, 6, 60});
    QApplication::processEvents();
    QTreeWidgetItem* row = list().topLevelItem(0);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualItemRect(row).center());
    EXPECT_NEAR(model().crosshair().y(), -8.0, 0.51);
    EXPECT_NEAR(model().crosshair().z(), 20.0, 1.0);
    EXPECT_TRUE(model().measurementData()[0].isSelected);

    QTest::keyClick(&list(), Qt::Key_Delete);
    EXPECT_TRUE(measurements().empty());
}

TEST_F(WindowSliceMeasure, ReportAndTableHaveIt)
{
    QTest::keyClick(&view(BodyPlane::Sagittal), Qt::Key_D, Qt::ShiftModifier);
    const double x = view(BodyPlane::Sagittal).grid().firstInPatient.x();
    dragLength(BodyPlane::Sagittal, {x, 0, 10}, {x, 0, 40});
    ASSERT_EQ(measurements().size(), 1U);
    const std::string table = io::measurementTable(w.current());
    EXPECT_NE(table.find("\n,,length,,"), std::string::npos) << table;
    EXPECT_NE(table.find(",mm,sagittal,,,,scan,"), std::string::npos) << table;
    const auto rows = measurementRows(w.current());
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_TRUE(rows.front().second.contains(QStringLiteral("Sagittal, x ")));
}

TEST_F(WindowSliceMeasure, OtherModesEndItAndSeedsAreSetAgain)
{
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_D, Qt::ShiftModifier);
    ASSERT_TRUE(model().tool());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_X, Qt::ShiftModifier);   // target points
    EXPECT_FALSE(model().tool());
    EXPECT_FALSE(w.window.actions()[ui::Command::MeasureLength]->isChecked());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_G, Qt::ShiftModifier);
    EXPECT_TRUE(model().tool());
    EXPECT_FALSE(w.window.actions()[ui::Command::TargetPoint]->isChecked());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Escape);
    EXPECT_FALSE(model().tool());
    EXPECT_FALSE(w.window.actions()[ui::Command::MeasureAngle]->isChecked());
}

}   // namespace
}   // namespace angiopose::app
