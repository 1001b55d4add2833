#include "tests/app/beside_window.h"

#include "core/geometry/epipolar_line.h"

namespace angiopose::app {
namespace {

using test::BesideWindow;

/// A point on the tree, well inside the shown image, and the widget px nearest to its projection.
struct SeenPlace {
    Eigen::Vector3d inPatient;
    QPoint at;
};

SeenPlace seenPlace(BesideWindow& w)
{
    for (const core::VesselBranch& branch : w.current().vessels.tree->branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const auto here = w.image().positionOf(point);
            const auto there = w.other().positionOf(point);
            const QRectF inside = QRectF(w.image().rect()).adjusted(60, 120, -60, -120);
            if (here && there && inside.contains(*here) && QRectF(w.other().rect()).contains(*there)) {
                return {point, here->toPoint()};
            }
        }
    }
    ADD_FAILURE() << "no point of the tree is seen in both views";
    return {};
}

double distancePx(const core::ImageSegment& line, const Eigen::Vector2d& point)
{
    const Eigen::Vector2d way = (line.endPx - line.beginPx).normalized();
    const Eigen::Vector2d from = point - line.beginPx;
    return std::abs(way.x() * from.y() - way.y() * from.x());
}

TEST(WindowCrosshair, ThePointerIsALineInTheOtherViewThroughWhatItPointsAt)
{
    BesideWindow w;
    const SeenPlace place = seenPlace(w);
    w.pointAt(w.image(), place.at);
    ASSERT_TRUE(w.other().crosshair().linePx);
    EXPECT_FALSE(w.image().crosshair().linePx) << "under the pointer it would be a point";
    const auto seenIn = [](const ui::AngiogramView& image, const Eigen::Vector3d& point) {
        return *core::project(image.camera(), image.cameraFromPatient() * point);
    };
    // The pointer has integer widget px; the exact point under it lies on its own ray, at the depth of the place.
    const Eigen::Vector3d inCamera = w.image().cameraFromPatient() * place.inPatient;
    const Eigen::Vector3d ray = core::rayThroughPixel(w.image().camera(), w.image().imageFromWidget(place.at));
    const Eigen::Vector3d pointed =
        w.image().cameraFromPatient().inverse() * Eigen::Vector3d(ray * (inCamera.z() / ray.z()));
    ASSERT_LT((pointed - place.inPatient).norm(), 1.0);
    EXPECT_LT(distancePx(*w.other().crosshair().linePx, seenIn(w.other(), pointed)), 1e-6);
    EXPECT_LT(distancePx(*w.other().crosshair().linePx, seenIn(w.other(), place.inPatient)), 1.0 / w.image().zoom());

    for (ui::AngiogramView* image : w.images().images()) {   // the vessel under the pointer is a point in all images
        ASSERT_TRUE(image->crosshair().pointInPatient);
        EXPECT_LT((seenIn(w.image(), *image->crosshair().pointInPatient) - seenIn(w.image(), place.inPatient)).norm(),
                  2.0 / w.image().zoom());
    }
}

TEST(WindowCrosshair, TheLineFollowsPosesAndGoesWithThePointerOrByKey)
{
    BesideWindow w;
    const SeenPlace place = seenPlace(w);
    w.pointAt(w.image(), place.at);
    ASSERT_TRUE(w.other().crosshair().linePx);
    w.setTogether(false);   // moves the pointer out of the image
    w.pointAt(w.image(), place.at);
    const Eigen::Vector2d before = w.other().crosshair().linePx->beginPx;
    w.press(Qt::Key_N);
    w.press(Qt::Key_PageUp, Qt::ShiftModifier);
    w.press(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_TRUE(test::waitFor([&] { return w.other().crosshair().linePx->beginPx != before; }));
    const core::PosedCamera first{w.image().camera(), w.image().cameraFromPatient()};
    const core::PosedCamera second{w.other().camera(), w.other().cameraFromPatient()};
    const auto expected = core::epipolarLine(first, w.image().imageFromWidget(place.at), second);
    ASSERT_TRUE(expected);
    EXPECT_LT((w.other().crosshair().linePx->beginPx - expected->beginPx).norm(), 1e-9);

    w.press(Qt::Key_N);
    w.press(Qt::Key_Z);
    EXPECT_FALSE(w.other().crosshair().linePx);
    w.pointAt(w.image(), place.at);
    EXPECT_FALSE(w.other().crosshair().linePx);
    w.press(Qt::Key_Z);
    EXPECT_TRUE(w.other().crosshair().linePx);

    w.pointAt(w.other(), w.other().rect().center());   // vice versa
    EXPECT_TRUE(w.image().crosshair().linePx);
    EXPECT_FALSE(w.other().crosshair().linePx);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&w.other(), &leave);
    EXPECT_FALSE(w.image().crosshair().linePx);
}

}   // namespace
}   // namespace angiopose::app
