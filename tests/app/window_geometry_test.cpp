#include "core/registration/pose/landmark_pose.h"
#include "io/image_file.h"
#include "tests/app/open_window.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"
#include "ui/controls/number_field.h"

#include <QListWidget>

namespace angiopose::app {
namespace {

using test::OpenWindow;
using test::SampleWindow;

ui::NumberField* fieldNamed(OpenWindow& w, const QString& help)
{
    for (ui::NumberField* field : w.window.geometryPanel().findChildren<ui::NumberField*>()) {
        if (field->accessibleName() == help) {
            return field;
        }
    }
    return nullptr;
}

QPoint inTreeView(OpenWindow& w, const Eigen::Vector3d& point)
{
    ui::TreeView& view = w.window.treeView();
    const Eigen::Vector2d device = view.scene().deviceFromPatient(point) / view.devicePixelRatio();
    return QPointF(device.x(), view.height() - device.y()).toPoint();
}

QPoint inImage(OpenWindow& w, const Eigen::Vector2d& pixel)
{
    return w.window.angiogramView().widgetFromImage(pixel).toPoint();
}

/// Bifurcations and endpoints that can be clicked in both views.
std::vector<Eigen::Vector3d> visibleNodes(OpenWindow& w)
{
    std::vector<Eigen::Vector3d> nodes;
    const auto camera = core::cameraOf(w.current().shown()).value();
    for (const core::VesselNode& node : core::findNodes(*w.current().vessels.tree)) {
        const auto pixel = core::project(camera, w.current().shown().cameraFromPatient * node.pointInPatient);
        const QPoint place = inTreeView(w, node.pointInPatient);
        const double ratio = w.window.treeView().devicePixelRatio();
        const auto pick = w.window.treeView().scene().pickAt(
            static_cast<int>(place.x() * ratio), static_cast<int>((w.window.treeView().height() - place.y()) * ratio));
        const bool isInFront = pick && (pick->pointInPatient - node.pointInPatient).norm() < 3.0;
        if (isInFront && pixel &&
            w.window.angiogramView().rect().adjusted(40, 40, -40, -40).contains(inImage(w, *pixel))) {
            nodes.push_back(node.pointInPatient);
        }
    }
    return nodes;
}

}   // namespace

TEST(WindowGeometry, AsksForThePixelSpacingThatTheHeaderLacks)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/views-A/IM3.dcm");
    OpenWindow w;
    w.drop({QString::fromStdString(test::dataFile("coronary-phantom-xa/tree/Centerlines.vtk").string()),
            QString::fromStdString(test::dataFile("coronary-phantom-xa/views-A/IM3.dcm").string())});
    ui::NumberField* spacing =
        fieldNamed(w, QStringLiteral("Pixel spacing at the detector. Press Enter to confirm a derived value."));
    ASSERT_TRUE(spacing);
    EXPECT_TRUE(spacing->property("asking").toBool());   // merely derived from the field of view
    EXPECT_EQ(w.current().shown().geometry.cArm.columnSpacingMm.origin, core::Origin::Derived);

    w.window.geometryPanel().setFolded(false);
    spacing->setFocus();
    QTest::keyClick(spacing, Qt::Key_Return);

    EXPECT_EQ(w.current().shown().geometry.cArm.columnSpacingMm.origin, core::Origin::User);
    EXPECT_DOUBLE_EQ(*w.current().shown().geometry.cArm.columnSpacingMm.value, 0.390625);
    EXPECT_FALSE(spacing->property("asking").toBool());
    EXPECT_EQ(w.history().count(), 1);
}

TEST(WindowGeometry, FieldsOfWhatIsMissingAreInSight)
{
    const test::TemporaryFolder folder;
    SampleWindow w;
    core::Mask2d picture(300, 200);
    picture.at(20, 30) = 1;
    ASSERT_TRUE(io::writePng(picture, folder.file("plain.png")));
    w.controller.document().replace({}, {});
    w.window.resize(1280, 760);
    w.drop({QString::fromStdString(folder.file("plain.png"))});
    ASSERT_TRUE(test::waitFor([&] { return w.current().shown().angiogram != nullptr; }));
    QTest::qWait(50);
    EXPECT_FALSE(w.window.geometryPanel().isFolded());
    const QLineEdit* first = w.window.geometryPanel().findChild<ui::NumberField*>();
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->visibleRegion().isEmpty());
}

TEST(WindowGeometry, SaysWhatContradictsAndTakesItBack)
{
    SampleWindow w;
    w.window.geometryPanel().setFolded(false);
    ui::NumberField* sod = fieldNamed(w, QStringLiteral("Source-to-isocenter distance"));
    ASSERT_TRUE(sod);
    core::Case plain = w.current();
    plain.shown().geometry.cameraOverride.reset();
    ASSERT_TRUE(core::cameraOf(plain.shown()));
    w.controller.document().replace(plain, {});
    sod->setFocus();
    sod->selectAll();
    QTest::keyClicks(sod, QStringLiteral("2500"));
    QTest::keyClick(sod, Qt::Key_Return);
    EXPECT_FALSE(core::contradictionsOf(w.current().shown()).empty());
    w.controller.document().undoStack().undo();
    EXPECT_TRUE(core::contradictionsOf(w.current().shown()).empty());
}

TEST(WindowLandmarks, PairsClickedInBothViewsGiveTheInitialPoseAsOneStep)
{
    SampleWindow w;
    const auto camera = core::cameraOf(w.current().shown()).value();
    const std::vector<Eigen::Vector3d> nodes = visibleNodes(w);
    ASSERT_GE(nodes.size(), 5U);
    const core::RigidTransform start = w.current().shown().cameraFromPatient;
    const core::RigidTransform wanted{start.rotation, start.translation + Eigen::Vector3d(6.0, -4.0, 10.0)};

    w.press(Qt::Key_L);
    QTest::qWait(100);
    for (std::size_t i = 0; i < 5; ++i) {
        QTest::mouseClick(&w.window.treeView(), Qt::LeftButton, Qt::NoModifier, inTreeView(w, nodes[i]));
        QTest::mouseClick(&w.window.angiogramView(), Qt::LeftButton, Qt::NoModifier,
                          inImage(w, *core::project(camera, wanted * nodes[i])));
        ASSERT_EQ(w.current().shown().landmarks.size(), i + 1);
    }
    EXPECT_EQ(w.window.landmarks().findChild<QListWidget*>()->count(), 5);
    const int steps = w.history().count();
    w.press(Qt::Key_Return);

    EXPECT_EQ(w.history().count(), steps + 1);
    EXPECT_TRUE(w.current().shown().initialCameraFromPatient);
    const auto errors =
        core::landmarkErrorsPx(w.current().shown().landmarks, camera, w.current().shown().cameraFromPatient);
    for (const double error : errors) {
        EXPECT_LT(error, 3.0);   // clicks have integer widget pixels, and nodes occlude each other in 3-D
    }
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, start), 1e-12);
    EXPECT_EQ(w.current().shown().landmarks.size(), 5U);
}

TEST(WindowLandmarks, NodesAreDrawnToTheirPlaceMovedAndRemoved)
{
    SampleWindow w;
    const auto camera = core::cameraOf(w.current().shown()).value();
    const std::vector<Eigen::Vector3d> nodes = visibleNodes(w);
    ASSERT_FALSE(nodes.empty());
    const QPoint from = inImage(w, *core::project(camera, w.current().shown().cameraFromPatient * nodes[0]));
    const auto drag = [&w](const QPoint& a, const QPoint& b) {
        QWidget* view = &w.window.angiogramView();
        QTest::mousePress(view, Qt::LeftButton, Qt::NoModifier, a);
        QTest::mouseMove(view, (a + b) / 2);
        QTest::mouseMove(view, b);
        QTest::mouseRelease(view, Qt::LeftButton, Qt::NoModifier, b);
    };
    w.press(Qt::Key_L);
    drag(from, from + QPoint(25, 14));
    ASSERT_EQ(w.current().shown().landmarks.size(), 1U);
    const Eigen::Vector2d first = w.current().shown().landmarks[0].pixel;
    drag(from + QPoint(25, 14), from + QPoint(35, 14));
    ASSERT_EQ(w.current().shown().landmarks.size(), 1U);
    EXPECT_GT(w.current().shown().landmarks[0].pixel.x(), first.x());
    w.press(Qt::Key_Delete);
    EXPECT_TRUE(w.current().shown().landmarks.empty());
    EXPECT_EQ(w.history().count(), 3);
    w.press(Qt::Key_Escape);
    EXPECT_EQ(w.window.angiogramView().tool(), nullptr);
}

TEST(WindowInitialPose, ComesFromHandOrAnglesInOneStepEach)
{
    SampleWindow w;
    const core::RigidTransform start = w.current().shown().cameraFromPatient;
    w.press(Qt::Key_N);
    w.press(Qt::Key_Right, Qt::ShiftModifier);
    w.press(Qt::Key_Backspace, Qt::ShiftModifier);
    EXPECT_NEAR(w.controller.pose().currentOffset()->rightMm, 0.0, 1e-9);   // this is the initial pose now
    EXPECT_GT(test::distance(*w.current().shown().initialCameraFromPatient, start), 1.0);

    w.press(Qt::Key_Backspace, Qt::ControlModifier);
    EXPECT_FALSE(w.current().shown().initialCameraFromPatient);
    EXPECT_LT(test::distance(w.current().shown().cameraFromPatient, core::initialPoseOf(w.current()).value()), 1e-12);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(w.current().shown().initialCameraFromPatient);
    EXPECT_EQ(w.history().index(), 2);
}

TEST(WindowLandmarks, ComeBackWithTheCase)
{
    test::TemporaryFolder folder;
    SampleWindow w;
    const std::vector<Eigen::Vector3d> nodes = visibleNodes(w);
    ASSERT_FALSE(nodes.empty());
    w.press(Qt::Key_L);
    const auto pixel =
        *core::project(core::cameraOf(w.current().shown()).value(), w.current().shown().cameraFromPatient * nodes[0]);
    QTest::mouseClick(&w.window.treeView(), Qt::LeftButton, Qt::NoModifier, inTreeView(w, nodes[0]));
    QTest::mouseClick(&w.window.angiogramView(), Qt::LeftButton, Qt::NoModifier, inImage(w, pixel));
    ASSERT_EQ(w.current().shown().landmarks.size(), 1U);
    const std::vector<core::Landmark> made = w.current().shown().landmarks;
    const QString path = QString::fromStdString(folder.file("with-landmarks.angiopose"));
    w.controller.saveController().saveTo(path);
    ASSERT_TRUE(test::waitFor([&] { return !w.controller.document().isModified(); }));
    w.drop({path});
    EXPECT_EQ(w.current().shown().landmarks, made);
}

TEST(WindowSides, TheMirroredViewMovesWithTheHand)
{
    SampleWindow w;
    ui::AngiogramView& view = w.window.angiogramView();
    const Eigen::Vector2d spot(120.0, 200.0);
    const double before = view.widgetFromImage(spot).x();
    w.press(Qt::Key_Q);
    EXPECT_TRUE(view.isFromSource());
    EXPECT_NEAR(view.widgetFromImage(spot).x(), view.width() - before, 1.0);
    EXPECT_LT((view.imageFromWidget(view.widgetFromImage(spot)) - spot).norm(), 1e-9);
    EXPECT_LT(view.visiblePart().left, view.visiblePart().right);

    w.press(Qt::Key_N);
    w.press(Qt::Key_Right);
    EXPECT_NEAR(w.controller.pose().currentOffset()->rightMm, -1.0, 1e-9);   // right on the screen is left in the image
    EXPECT_NEAR(w.current().shown().cameraFromPatient.rotation.determinant(), 1.0, 1e-12);
}

}   // namespace angiopose::app
