#include "core/geometry/angle_units.h"
#include "core/measuring/measure_image.h"
#include "tests/support/for_each.h"
#include "ui/slices/slice_measure_tool.h"
#include "ui/slices/slice_view.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>
#include <numbers>

namespace angiopose::ui {
namespace {

using core::BodyPlane;
using core::MeasurementKind;
using core::SliceMeasurement;

constexpr double tubeRadiusMm = 6.0;

/// Share of a voxel inside the tube along z through (0, 0, ·).
double shareInTube(const Eigen::Affine3d& map, const Eigen::Vector3d& voxel)
{
    const Eigen::Vector3d middle = map * voxel;
    const double away = std::hypot(middle.x(), middle.y()) - tubeRadiusMm;
    if (std::abs(away) > 0.5 * map.linear().colwise().norm().sum()) {
        return away < 0.0 ? 1.0 : 0.0;
    }
    constexpr int parts = 4;
    int inside = 0;
    for (int p = 0; p < parts * parts * parts; ++p) {
        const Eigen::Array3d part(p % parts, p / parts % parts, p / parts / parts);
        const Eigen::Vector3d at = map * (voxel + ((part + 0.5) / parts - 0.5).matrix());
        inside += std::hypot(at.x(), at.y()) < tubeRadiusMm ? 1 : 0;
    }
    return static_cast<double>(inside) / (parts * parts * parts);
}

/// An opacified tube of 12 mm diameter in the given voxels, with the brightness of each voxel given by its share inside
/// the tube.
core::Volume tubeIn(const core::VolumeGeometry& geometry)
{
    core::Volume scan(geometry);
    const Eigen::Affine3d map = geometry.patientFromVoxel();
    test::forEachVoxel(geometry.size, [&](int i, int j, int k) {
        scan.at(i, j, k) = static_cast<std::int16_t>(-900 + 1200.0 * shareInTube(map, {1.0 * i, 1.0 * j, 1.0 * k}));
    });
    return scan;
}

/// A grid with any axis order and direction, the patient origin at its center.
core::VolumeGeometry voxels(const Eigen::Vector3i& size, const Eigen::Vector3d& spacingMm,
                            const Eigen::Matrix3d& direction)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacingMm = spacingMm;
    geometry.direction = direction;
    geometry.originInPatient -= geometry.patientFromVoxel() * (0.5 * (size.cast<double>().array() - 1.0)).matrix();
    return geometry;
}

struct MeasuredSliceView {
    explicit MeasuredSliceView(const core::VolumeGeometry& geometry, BodyPlane plane, MeasurementKind kind)
        : view(model, plane), tool(kind, model)
    {
        model.setScan(std::make_shared<const core::Volume>(tubeIn(geometry)), nullptr);
        model.setWindow({1200.0, -300.0});
        model.setCrosshair(Eigen::Vector3d::Zero());
        QObject::connect(&tool, &SliceMeasureTool::drawn, &view, [this](const SliceMeasurement& what) {
            drawn.push_back(what);
            model.setMeasurements({{drawn.back(), {}, false}});
        });
        view.resize(500, 420);
        view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        view.fit();
        model.setTool(&tool);
        EXPECT_EQ(view.cursor().shape(), Qt::CrossCursor);
    }

    /// Screen positions of the tube's edges to the left and right of its axis, halfway between bright and dark, as a
    /// user would place them.
    std::pair<QPoint, QPoint> edgesInPicture()
    {
        model.setTool(nullptr);   // shows only the scan
        view.clearFocus();
        const QImage picture = view.grab().toImage();
        model.setTool(&tool);
        const double ratio = view.devicePixelRatio();
        const QPointF axis = view.widgetFromPatient({0, 0, 0}) + QPointF(0, 17);   // off the line of the crosshair
        const int row = static_cast<int>(std::lround(axis.y() * ratio));
        const auto isBright = [&](int column) { return qGray(picture.pixel(column, row)) > 127; };
        int left = static_cast<int>(std::lround(axis.x() * ratio)) - 3;
        int right = left + 6;
        while (left > 0 && isBright(left)) {
            --left;
        }
        while (right < picture.width() - 1 && isBright(right)) {
            ++right;
        }
        const int y = static_cast<int>(std::lround(axis.y()));
        return {{static_cast<int>(std::lround((left + 0.5) / ratio)), y},
                {static_cast<int>(std::lround((right + 0.5) / ratio)), y}};
    }

    void drag(const QPoint& from, const QPoint& to)
    {
        QTest::mousePress(&view, Qt::LeftButton, Qt::NoModifier, from);
        QTest::mouseMove(&view, (from + to) / 2);
        QTest::mouseMove(&view, to);
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::NoModifier, to);
    }
    void click(const Eigen::Vector3d& point)
    {
        const QPoint at = view.widgetFromPatient(point).toPoint();
        QTest::mouseMove(&view, at);
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, at);
    }

    SliceModel model;
    SliceView view;
    SliceMeasureTool tool;
    std::vector<SliceMeasurement> drawn;
};

void expectTubeOf12Mm(const core::VolumeGeometry& geometry, BodyPlane plane, double minVoxelMm)
{
    MeasuredSliceView s(geometry, plane, MeasurementKind::Length);
    const auto [left, right] = s.edgesInPicture();
    const double awayMm =
        plane == BodyPlane::Axial ? 17.0 / s.view.pxPerMm() : 0.0;   // distance of the measured chord from the axis
    s.drag(left, right);
    ASSERT_EQ(s.drawn.size(), 1U);
    const double chordMm = 2.0 * std::sqrt(tubeRadiusMm * tubeRadiusMm - awayMm * awayMm);
    EXPECT_NEAR(core::valueOf(s.drawn[0]).value().value, chordMm, 0.5 * minVoxelMm + 1.0 / s.view.pxPerMm());
    EXPECT_EQ(s.drawn[0].plane, plane);
}

TEST(SliceMeasure, TheWidthOfAKnownTubeInUnequalVoxels)
{
    const auto geometry = voxels({60, 40, 12}, {0.5, 1.0, 3.0}, Eigen::Matrix3d::Identity());
    expectTubeOf12Mm(geometry, BodyPlane::Axial, 0.5);
    expectTubeOf12Mm(geometry, BodyPlane::Coronal, 0.5);
    expectTubeOf12Mm(geometry, BodyPlane::Sagittal, 1.0);
}

TEST(SliceMeasure, TheWidthOfAKnownTubeInMirroredAndReorderedVoxels)
{
    Eigen::Matrix3d direction;   // i to the feet, j to the right, k to the front: left-handed
    direction << 0, -1, 0, 0, 0, -1, -1, 0, 0;
    ASSERT_LT(direction.determinant() * Eigen::Matrix3d::Identity().determinant(), 0.0);
    const auto geometry = voxels({12, 60, 40}, {3.0, 0.5, 1.0}, direction);
    expectTubeOf12Mm(geometry, BodyPlane::Axial, 0.5);
    expectTubeOf12Mm(geometry, BodyPlane::Coronal, 0.5);
    expectTubeOf12Mm(geometry, BodyPlane::Sagittal, 1.0);
}

TEST(SliceMeasure, TheWidthOfAKnownTubeInATiltedScan)
{
    const Eigen::Matrix3d tilted =
        Eigen::AngleAxisd(18.0 * core::radiansPerDegree, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const auto geometry = voxels({60, 50, 30}, {0.6, 0.6, 1.5}, tilted);
    expectTubeOf12Mm(geometry, BodyPlane::Axial, 0.6);
    expectTubeOf12Mm(geometry, BodyPlane::Coronal, 0.6);
    expectTubeOf12Mm(geometry, BodyPlane::Sagittal, 1.5);
}

TEST(SliceMeasure, AnglesAndAreasByClicks)
{
    const auto geometry = voxels({60, 40, 12}, {0.5, 1.0, 3.0}, Eigen::Matrix3d::Identity());
    MeasuredSliceView angle(geometry, BodyPlane::Coronal, MeasurementKind::Angle);
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(10, 0, 0), {0, 0, 0}, {0, 0, 12}}) {
        angle.click(point);
    }
    ASSERT_EQ(angle.drawn.size(), 1U);
    EXPECT_NEAR(core::valueOf(angle.drawn[0]).value().value, 90.0, 1.0);

    MeasuredSliceView area(geometry, BodyPlane::Axial, MeasurementKind::Area);
    for (int n = 0; n < 24; ++n) {
        const double turn = 2.0 * std::numbers::pi * n / 24;
        area.click({tubeRadiusMm * std::cos(turn), tubeRadiusMm * std::sin(turn), 0});
        QTest::qWait(QApplication::doubleClickInterval() / 20);
    }
    QTest::keyClick(&area.view, Qt::Key_Return);
    ASSERT_EQ(area.drawn.size(), 1U);
    const double polygonMm2 = 12.0 * tubeRadiusMm * tubeRadiusMm * std::sin(2.0 * std::numbers::pi / 24);
    EXPECT_NEAR(core::valueOf(area.drawn[0]).value().value, polygonMm2, 0.02 * polygonMm2);
}

TEST(SliceMeasure, PointsStayInOneSliceAndEscTakesBack)
{
    const auto geometry = voxels({60, 40, 12}, {0.5, 1.0, 3.0}, Eigen::Matrix3d::Identity());
    MeasuredSliceView s(geometry, BodyPlane::Axial, MeasurementKind::Length);
    s.click({-5, 0, 0});
    s.view.stepBy(1);
    s.click({5, 3, 0});
    EXPECT_TRUE(s.drawn.empty()) << "the first point lies in another slice";
    s.click({-5, 3, 0});
    ASSERT_EQ(s.drawn.size(), 1U);
    EXPECT_NEAR(core::valueOf(s.drawn[0]).value().value, 10.0, 2.0 / s.view.pxPerMm());
    EXPECT_NEAR(core::slicePositionMm(s.drawn[0]), s.view.grid().firstInPatient.z(), 1e-9);

    QSignalSpy moved(&s.tool, &SliceMeasureTool::pointMoved);
    const QPoint end = s.view.widgetFromPatient(s.drawn[0].pointsInPatient[0]).toPoint();
    s.drag(end, end + QPoint(0, 40));
    ASSERT_EQ(moved.size(), 1);
    EXPECT_EQ(moved[0][1].toInt(), 0);

    s.click({0, -8, 0});
    QTest::keyClick(&s.view, Qt::Key_Escape);
    EXPECT_EQ(s.model.tool(), &s.tool) << "the first Esc takes the point back";
    QTest::keyClick(&s.view, Qt::Key_Escape);
    EXPECT_EQ(s.model.tool(), nullptr);
    const Eigen::Vector3d before = s.model.crosshair();
    s.click({4, 4, 0});
    EXPECT_NE(s.model.crosshair(), before) << "the mouse has its old meaning";
}

}   // namespace
}   // namespace angiopose::ui
