#include "tests/app/scan_window.h"
#include "ui/slices/mask_panel.h"
#include "ui/slices/slice_model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>

#include <algorithm>

namespace angiopose::app {
namespace {

using core::BodyPlane;
using ui::Command;

/// Largest z of the arm on the patient's left, mm.
double reachOfTheCutArm(const core::VesselTree& tree)
{
    double highest = 0.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            highest = point.x() > 3.0 ? std::max(highest, point.z()) : highest;
        }
    }
    return highest;
}

class WindowMask : public test::ScanWindow {
protected:
    void SetUp() override
    {
        ScanWindow::SetUp();
        settings::isBrush3d.write(false);
        settings::cutDepth.write(0);
        settings::brushRadiusMm.write(2.0);
        for (QCheckBox* box : panel().findChildren<QCheckBox*>()) {
            box->setChecked(false);
        }
        panel().findChild<QComboBox*>()->setCurrentIndex(0);
        emit panel().findChild<QComboBox*>()->activated(0);
        ASSERT_TRUE(w.current().vessels.lumen);
    }

    ui::MaskPanel& panel() { return w.window.tracing().mask(); }
    MaskController& mask() { return w.controller.mask(); }
    std::size_t setVoxels()
    {
        return static_cast<std::size_t>(std::ranges::count_if(model().mask()->voxels, [](auto v) { return v != 0; }));
    }
    bool isSetAt(const Eigen::Vector3d& point)
    {
        const core::VoxelMask& shown = *model().mask();
        const Eigen::Vector3i at = (shown.geometry.patientFromVoxel().inverse() * point).array().round().cast<int>();
        return shown.at(at.x(), at.y(), at.z()) != 0;
    }
    double showAxialSlice()
    {
        model().setCrosshair({0, 0, 20});
        QApplication::processEvents();
        return view(BodyPlane::Axial).grid().firstInPatient.z();
    }
    void begin(Qt::Key key)
    {
        QTest::keyClick(&view(BodyPlane::Axial), key, Qt::ControlModifier);
        ASSERT_TRUE(model().tool());
        ASSERT_TRUE(test::waitFor([this] { return !mask().isPreparing(); }));
    }
    void dragAlong(BodyPlane plane, const std::vector<Eigen::Vector3d>& points,
                   Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        ui::SliceView& v = view(plane);
        QTest::mousePress(&v, Qt::LeftButton, modifiers, placeOf(plane, points.front()));
        for (const Eigen::Vector3d& point : points) {
            QMouseEvent move(QEvent::MouseMove, QPointF(placeOf(plane, point)),
                             v.mapToGlobal(QPointF(placeOf(plane, point))), Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(&v, &move);
        }
        QTest::mouseRelease(&v, Qt::LeftButton, modifiers, placeOf(plane, points.back()));
    }
    void lasso(BodyPlane plane, const Eigen::Vector3d& middle, double halfMm, Qt::KeyboardModifiers modifiers = {})
    {
        const auto axes = core::axesOf(plane);
        const auto corner = [&](double right, double down) {
            return Eigen::Vector3d(middle + halfMm * (right * axes.right + down * axes.down));
        };
        dragAlong(plane,
                  {corner(-1, -1), corner(0, -1), corner(1, -1), corner(1, 0), corner(1, 1), corner(0, 1),
                   corner(-1, 1), corner(-1, 0)},
                  modifiers);
        ASSERT_TRUE(test::waitFor([this] { return !mask().isPreparing(); }));
    }
    bool waitForMask()
    {
        return test::waitFor([this] { return !mask().isRunning(); });
    }
};

TEST_F(WindowMask, AStrokeIsOneStepOfUndoInItsSliceAlone)
{
    const double z = showAxialSlice();
    const std::size_t before = setVoxels();
    const int steps = w.history().count();
    begin(Qt::Key_D);
    ASSERT_FALSE(isSetAt({12, 0, z}));
    const Eigen::Vector3d crosshair = model().crosshair();
    dragAlong(BodyPlane::Axial, {{10, 0, z}, {14, 0, z}, {16, 2, z}});
    EXPECT_TRUE(isSetAt({12, 0, z}));
    EXPECT_TRUE(isSetAt({16, 2, z}));
    EXPECT_FALSE(isSetAt({12, 0, z + 1}));
    EXPECT_EQ(w.history().count(), steps + 1);
    EXPECT_EQ(model().crosshair(), crosshair) << "painting moves no cross-hair";
    const std::size_t painted = setVoxels();
    EXPECT_GT(painted, before + 20);

    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(setVoxels(), before);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(setVoxels(), painted);
    dragAlong(BodyPlane::Axial, {{10, 0, z}, {14, 0, z}, {16, 2, z}}, Qt::ControlModifier);   // erases
    EXPECT_FALSE(isSetAt({12, 0, z}));
    EXPECT_EQ(w.history().count(), steps + 2);
}

TEST_F(WindowMask, TheBrushGrowsAndPaintsBallsAboveTheThreshold)
{
    const double z = showAxialSlice();
    begin(Qt::Key_D);
    for (int step = 0; step < 8; ++step) {
        wheel(BodyPlane::Axial, 1, Qt::ShiftModifier);
    }
    EXPECT_GT(settings::brushRadiusMm.read(), 5.0);
    EXPECT_NEAR(view(BodyPlane::Axial).grid().firstInPatient.z(), z, 1e-9) << "the slice stays";
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Minus);
    EXPECT_LT(settings::brushRadiusMm.read(), 6.0);

    for (QCheckBox* box : panel().findChildren<QCheckBox*>()) {
        box->setChecked(true);
    }
    const std::size_t before = setVoxels();
    dragAlong(BodyPlane::Axial, {{12, 0, z}, {13, 0, z}});
    EXPECT_EQ(setVoxels(), before) << "tissue is darker than the threshold";
    for (QCheckBox* box : panel().findChildren<QCheckBox*>()) {
        box->setChecked(box->text().startsWith(QStringLiteral("3-D brush")));
    }
    dragAlong(BodyPlane::Axial, {{12, 0, z}, {13, 0, z}});
    EXPECT_TRUE(isSetAt({12, 0, z + 4}));
    EXPECT_TRUE(isSetAt({12, 0, z - 4}));
}

TEST_F(WindowMask, ScissorsCutAndTheVesselsAreTracedAgain)
{
    const auto treeBefore = w.current().vessels.tree;
    ASSERT_GT(reachOfTheCutArm(*treeBefore), 75.0);
    begin(Qt::Key_X);
    QComboBox& depth = *panel().findChild<QComboBox*>();
    depth.setCurrentIndex(2);   // all slices
    emit depth.activated(2);
    model().setCrosshair({0, 0, 60});
    QApplication::processEvents();
    const double y = view(BodyPlane::Coronal).grid().firstInPatient.y();
    lasso(BodyPlane::Coronal, {18, y, 68}, 14.0);   // one of the arms
    EXPECT_FALSE(isSetAt({15, 3.75, 70}));
    EXPECT_TRUE(isSetAt({-15, 0, 70}));
    EXPECT_EQ(w.current().vessels.tree, treeBefore) << "traced when it is asked for";

    ASSERT_TRUE(w.window.actions()[Command::TraceMask]->isEnabled());
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_U, Qt::ControlModifier);
    ASSERT_TRUE(mask().isRunning());
    ASSERT_TRUE(waitForMask());
    EXPECT_LT(reachOfTheCutArm(*w.current().vessels.tree), 60.0) << "a stump is left";
    EXPECT_TRUE(w.current().vessels.isLumenEdited);
    EXPECT_EQ(w.current().vessels.scanFile.path, scanPath.toStdString());
    EXPECT_FALSE(w.window.actions()[Command::TraceMask]->isEnabled());

    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(w.current().vessels.tree, treeBefore);
    EXPECT_FALSE(w.current().vessels.isLumenEdited);
    EXPECT_FALSE(isSetAt({15, 3.75, 70})) << "the cut is a step of its own";
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(isSetAt({15, 3.75, 70}));
}

TEST_F(WindowMask, ShiftKeepsWhatLiesInside)
{
    begin(Qt::Key_X);
    const double z = showAxialSlice();
    lasso(BodyPlane::Axial, {0, 0, z}, 2.0, Qt::ShiftModifier);
    EXPECT_TRUE(isSetAt({0, 0, z}));
    EXPECT_FALSE(isSetAt({3.4, 0, z}));
    EXPECT_TRUE(isSetAt({3, 0, z + 1})) << "this slice";
}

TEST_F(WindowMask, TheScanCanBeTracedAgainAfterwards)
{
    begin(Qt::Key_R);
    const double z = showAxialSlice();
    dragAlong(BodyPlane::Axial, {{-5, 0, z}, {5, 0, z}});
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_U, Qt::ControlModifier);
    ASSERT_TRUE(waitForMask());
    ASSERT_TRUE(w.current().vessels.isLumenEdited);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_T, Qt::ControlModifier);
    ASSERT_TRUE(waitForTrace());
    EXPECT_FALSE(w.current().vessels.isLumenEdited);
    EXPECT_EQ(w.current().vessels.input.kind, core::VesselInputKind::Volume);
    EXPECT_EQ(w.current().vessels.file.path, scanPath.toStdString());
    EXPECT_EQ(model().mask(), w.current().vessels.lumen.get()) << "the new lumen is shown";
}

/// Undo while the mouse button is down concerns the current stroke only.
TEST_F(WindowMask, UndoInTheMiddleOfAStrokeTakesItBackAndNothingElse)
{
    const double z = showAxialSlice();
    begin(Qt::Key_D);
    dragAlong(BodyPlane::Axial, {{10, 8, z}, {14, 8, z}});
    const std::vector<std::uint8_t> before = model().mask()->voxels;
    ui::SliceView& axial = view(BodyPlane::Axial);
    const auto moveTo = [&](const Eigen::Vector3d& point) {
        const QPointF at(placeOf(BodyPlane::Axial, point));
        QMouseEvent move(QEvent::MouseMove, at, axial.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&axial, &move);
    };
    QTest::mousePress(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {10, 0, z}));
    moveTo({14, 0, z});
    ASSERT_NE(model().mask()->voxels, before);
    QTest::keyClick(&axial, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(model().mask()->voxels, before);
    moveTo({10, 0, z});
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {10, 0, z}));
    const std::vector<std::uint8_t> after = model().mask()->voxels;
    QTest::keyClick(&axial, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(model().mask()->voxels, before);
    QTest::keyClick(&axial, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(model().mask()->voxels, after);
}

/// Undo removes the trace during the first stroke on its lumen.
TEST_F(WindowMask, TheLumenMayGoWhileItIsPainted)
{
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_T, Qt::ControlModifier);
    ASSERT_TRUE(waitForTrace());
    const double z = showAxialSlice();
    begin(Qt::Key_D);
    ui::SliceView& axial = view(BodyPlane::Axial);
    QTest::mousePress(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {10, 0, z}));
    w.controller.document().replace({}, {});
    QTest::mouseRelease(&axial, Qt::LeftButton, {}, placeOf(BodyPlane::Axial, {12, 0, z}));
    EXPECT_EQ(w.history().count(), 0);
}

TEST_F(WindowMask, AnotherStrokeInItsPlaceIsAChange)
{
    const double z = showAxialSlice();
    begin(Qt::Key_D);
    dragAlong(BodyPlane::Axial, {{10, 0, z}, {14, 0, z}});
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_U, Qt::ControlModifier);
    ASSERT_TRUE(mask().isRunning());
    QTest::qWait(1);
    QTest::keyClick(&view(BodyPlane::Axial), Qt::Key_Z, Qt::ControlModifier);
    dragAlong(BodyPlane::Axial, {{10, 8, z}, {14, 8, z}});
    ASSERT_TRUE(waitForMask());
    if (w.current().vessels.isLumenEdited) {   // a fast worker took its copy before the undo
        EXPECT_TRUE(w.window.actions()[Command::TraceMask]->isEnabled()) << "the vessels know the other stroke";
    }
}

TEST_F(WindowMask, AStrokeIsWorkThatClosingAsksAbout)
{
    const double z = showAxialSlice();
    const auto revision = w.controller.document().state().revision;
    begin(Qt::Key_D);
    dragAlong(BodyPlane::Axial, {{10, 0, z}, {14, 0, z}});
    EXPECT_NE(w.controller.document().state().revision, revision);
    w.window.actions()[Command::CloseCase]->trigger();
    ASSERT_EQ(w.dialogs("closeQuestion").size(), 1);
    w.dialogs("closeQuestion").front()->close();
}

TEST_F(WindowMask, OpacityIsRemembered)
{
    panel().findChild<QSlider*>()->setValue(70);
    EXPECT_NEAR(model().maskOpacity(), 0.7, 1e-9);
    EXPECT_NEAR(settings::maskOpacity.read(), 0.7, 1e-9);
    settings::maskOpacity.write(0.28);
}

}   // namespace
}   // namespace angiopose::app
