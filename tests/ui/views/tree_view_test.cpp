#include "ui/views/tree_view.h"

#include "tests/support/for_each.h"
#include "tests/ui/overlay_fixture.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

using namespace angiopose;

namespace {

constexpr int patienceMs = 20000;

core::VesselTree straightVessel()
{
    core::VesselTree tree;
    core::VesselBranch branch;
    branch.id = 7;
    for (int i = 0; i <= 40; ++i) {
        branch.pointsInPatient.emplace_back(0.0, 0.0, i - 20.0);
    }
    branch.radiusMm.assign(branch.pointsInPatient.size(), 1.5);
    tree.branches = {branch};
    return tree;
}

int brightPixels(const QImage& picture)
{
    int count = 0;
    test::forEachPixel(picture.width(), picture.height(),
                       [&](int x, int y) { count += qGray(picture.pixel(x, y)) > 110; });
    return count;
}

class TreeViewTest : public ::testing::Test {
protected:
    TreeViewTest()
    {
        view_->resize(300, 300);
        view_->scene().setTree(straightVessel());
        view_->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(view_.get()));
    }
    /// Waits until the view has rendered and has had nothing more to render for half a second.
    void settle()
    {
        EXPECT_TRUE(QTest::qWaitFor([this] { return view_->renderCount() > 0; }, patienceMs));
        for (int seen = -1; seen != view_->renderCount();) {
            seen = view_->renderCount();
            QTest::qWait(500);
        }
    }

    std::unique_ptr<ui::TreeView> view_ = std::make_unique<ui::TreeView>();
};

TEST_F(TreeViewTest, SaysSoWhereThereIsNothing)
{
    settle();
    view_->scene().setTree({});
    view_->requestRender();
    settle();
    const QImage words = view_->grab().toImage();
    EXPECT_GT(brightPixels(words), 200);   // the text is in the middle, and nothing else is shown
    EXPECT_EQ(brightPixels(words.copy(0, 0, words.width(), words.height() / 4)), 0);
}

TEST_F(TreeViewTest, ShowsTheTreeAndFindsItsBranchUnderTheMouse)
{
    settle();
    EXPECT_GT(brightPixels(view_->grab().toImage()), 200);
    std::optional<int> hovered;
    QObject::connect(view_.get(), &ui::TreeView::branchHovered, [&hovered](auto id) { hovered = id; });
    QTest::mouseMove(view_.get(), {5, 5});
    QTest::mouseMove(view_.get(), {150, 150});
    EXPECT_TRUE(QTest::qWaitFor([&hovered] { return hovered == 7; }, patienceMs));
}

/// The usual clinical view, not from the head.
TEST_F(TreeViewTest, ShowsVesselsWithoutAnImageFromTheFrontHeadUp)
{
    settle();
    const ui::TreeScene& scene = view_->scene();
    const Eigen::Vector2d center = scene.deviceFromPatient({0.0, 0.0, 0.0});
    const Eigen::Vector2d head = scene.deviceFromPatient({0.0, 0.0, 10.0});
    const Eigen::Vector2d left = scene.deviceFromPatient({10.0, 0.0, 0.0});
    const Eigen::Vector2d back = scene.deviceFromPatient({0.0, 10.0, 0.0});
    EXPECT_GT((head - center).norm(), 20.0);
    EXPECT_NEAR(head.x(), center.x(), 1e-6);
    EXPECT_GT(left.x(), center.x() + 20.0);   // the patient's left is at the viewer's right
    EXPECT_LT((back - center).norm(), 1e-6);
}

TEST_F(TreeViewTest, ManyChangesMakeOneRedrawAndOneMoreWhenAtRest)
{
    settle();
    const int before = view_->renderCount();
    for (int i = 0; i < 20; ++i) {
        view_->requestRender();
    }
    EXPECT_TRUE(QTest::qWaitFor([this, before] { return view_->renderCount() >= before + 2; }, patienceMs));
    settle();
    EXPECT_EQ(view_->renderCount() - before, 2);
}

TEST_F(TreeViewTest, ShowsEverythingOrTheVesselsAlone)
{
    core::ProjectionCamera camera;
    camera.fx = -2500.0;
    camera.fy = 2500.0;
    camera.cx = camera.cy = 255.5;
    camera.width = camera.height = 512;
    core::RigidTransform pose;
    pose.translation = {0.0, 0.0, 750.0};
    view_->scene().setCamera(camera, 1000.0);
    view_->scene().setPose(pose);
    view_->requestRender();
    settle();
    const auto lengthPx = [this] {
        return (view_->scene().deviceFromPatient({0.0, 0.0, 20.0}) -
                view_->scene().deviceFromPatient({0.0, 0.0, -20.0}))
            .norm();
    };
    const double inAll = lengthPx();
    view_->nextView();
    settle();
    EXPECT_GT(lengthPx(), 3.0 * inAll) << "the source is 1 m away, the vessels are 40 mm long";
    EXPECT_LT(lengthPx(), 300.0 * view_->devicePixelRatio());
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    view_->nextView();
    settle();
    EXPECT_NEAR(lengthPx(), inAll, 1e-6 * inAll) << "what was zoomed by hand goes back to everything first";
}

TEST_F(TreeViewTest, ShowsTheWholeTreeInAnyShapeUntilItIsTurnedByHand)
{
    core::VesselTree across = straightVessel();
    for (Eigen::Vector3d& point : across.branches.front().pointsInPatient) {
        point = {3.0 * point.z(), 0.0, 0.0};
    }
    view_->scene().setTree(across);
    view_->nextView();
    settle();
    const auto endPx = [this] { return view_->scene().deviceFromPatient({60.0, 0.0, 0.0}); };
    const auto isSeen = [this](const Eigen::Vector2d& px) {
        const QSize size = view_->size() * view_->devicePixelRatio();
        return px.x() >= 0.0 && px.y() >= 0.0 && px.x() <= size.width() && px.y() <= size.height();
    };
    ASSERT_TRUE(isSeen(endPx()));
    const double inWide = (endPx() - view_->scene().deviceFromPatient({-60.0, 0.0, 0.0})).norm();
    view_->resize(90, 300);
    settle();
    EXPECT_TRUE(isSeen(endPx())) << endPx().transpose();
    view_->scene().turnBy(1.0, 0.0);
    view_->resize(300, 300);
    settle();
    const double turned = (endPx() - view_->scene().deviceFromPatient({-60.0, 0.0, 0.0})).norm();
    EXPECT_LT(turned, 0.9 * inWide) << "a view rotated manually is not reframed";
}

TEST_F(TreeViewTest, ShowsTheImageOnTheDetectorTheRightWayRoundAtAnySize)
{
    core::RigidTransform pose;
    pose.translation = {0.0, 0.0, 750.0};
    for (const int size : {5, 301, 512, 2048}) {
        const double focalPx = 5.0 * size;
        const double centerPx = 0.5 * (size - 1);
        view_->scene().setCamera({-focalPx, focalPx, centerPx, centerPx, size, size}, 1000.0);
        view_->scene().setPose(pose);
        core::ImageF frame(size, size);
        const int half = size / 2;
        test::forEachPixel(size, size, [&](int u, int v) {
            const float shade = 100.0F * static_cast<float>(u + v) / static_cast<float>(size);
            frame.at(u, v) = shade + (u < half && v < half ? 1000.0F : 0.0F);
        });
        view_->scene().setFrame(frame);
        view_->requestRender();
        settle();
        const QImage picture = view_->grab().toImage();
        const auto grayAt = [&](double across, double down) {   // as shares of the image size
            const Eigen::Vector3d inPatient((across * size - 0.5 - centerPx) * 1000.0 / -focalPx,
                                            (down * size - 0.5 - centerPx) * 1000.0 / focalPx, 250.0);
            const Eigen::Vector2d px = view_->scene().deviceFromPatient(inPatient);
            return qGray(picture.pixel(static_cast<int>(px.x()), picture.height() - 1 - static_cast<int>(px.y())));
        };
        const double near = 0.5 * half / size;
        for (const auto& [across, down] :
             {std::pair{0.7, near}, {near, 0.8}, {0.7, 0.8}}) {   // outside the edges of the beam
            EXPECT_GT(grayAt(near, near), grayAt(across, down) + 50) << size << ": " << across << ", " << down;
        }
    }
}

TEST_F(TreeViewTest, EdgesAreSmoothAtRest)
{
    settle();
    view_->scene().turnBy(0.0, 3.0);
    const int before = view_->renderCount();
    view_->requestRender();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view_->renderCount() > before; }, patienceMs));
    const QImage draft = view_->grab().toImage();
    settle();
    const QImage atRest = view_->grab().toImage();
    EXPECT_EQ(view_->renderCount(), before + 2);
    const auto shades = [](const QImage& picture) {
        std::set<QRgb> colors;
        test::forEachPixel(picture.width(), picture.height(),
                           [&](int x, int y) { colors.insert(picture.pixel(x, y)); });
        return colors.size();
    };
    EXPECT_GT(static_cast<double>(shades(atRest)), 1.5 * static_cast<double>(shades(draft)));
    EXPECT_NEAR(brightPixels(atRest), brightPixels(draft), 0.15 * brightPixels(draft)) << "nothing else changes";
}

TEST(TreeViewBeforeItIsShown, RehearsesWithoutATrace)
{
    const auto pictureOf = [](bool isWarm) {
        ui::TreeView view;
        view.resize(300, 300);
        if (isWarm) {
            view.warmUp();
            EXPECT_EQ(view.renderCount(), 0);
        }
        view.scene().setTree(straightVessel());
        view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        EXPECT_TRUE(QTest::qWaitFor([&view] { return view.renderCount() >= 2; }, patienceMs));
        return view.grab().toImage();
    };
    const QImage warm = pictureOf(true);
    EXPECT_GT(brightPixels(warm), 200);
    EXPECT_EQ(warm, pictureOf(false));
}

TEST_F(TreeViewTest, DrawsNothingWhileHidden)
{
    settle();
    view_->hide();
    const int before = view_->renderCount();
    view_->requestRender();
    settle();
    EXPECT_EQ(view_->renderCount(), before);
    view_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(view_.get()));
    EXPECT_TRUE(QTest::qWaitFor([this, before] { return view_->renderCount() > before; }, patienceMs));
}

TEST_F(TreeViewTest, MovesToAnotherWindow)
{
    QWidget host;
    host.resize(400, 400);
    auto* layout = new QVBoxLayout(&host);
    layout->addWidget(view_.get());
    host.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&host));
    settle();
    EXPECT_GT(brightPixels(view_->grab().toImage()), 200);
    view_.reset();
}

TEST_F(TreeViewTest, ShowsThePictureOfAScanBehindTheTree)
{
    settle();
    const core::ParallelProjection projection = view_->scene().projection(20000);
    EXPECT_LE(projection.width * projection.height, 21000);
    core::Image2d<core::Rgba> pixels(projection.width, projection.height, {0, 160, 0, 255});
    for (int y = 0; y < projection.height / 2; ++y) {
        std::fill_n(&pixels.at(0, y), projection.width, core::Rgba{});   // the lower half is empty
    }
    view_->scene().setScanRendering({projection, pixels});
    view_->requestRender();
    settle();
    const QImage picture = view_->grab().toImage();
    const auto isGreen = [](QRgb pixel) {
        return qGreen(pixel) > qRed(pixel) + 60 && qGreen(pixel) > qBlue(pixel) + 60;
    };
    EXPECT_TRUE(isGreen(picture.pixel(picture.width() / 4, picture.height() / 4)));
    EXPECT_FALSE(isGreen(picture.pixel(picture.width() / 4, 3 * picture.height() / 4)));
    EXPECT_FALSE(isGreen(picture.pixel(picture.width() / 2, picture.height() / 4))) << "the vessel lies before it";
    view_->scene().setScanRendering({});
    view_->requestRender();
    settle();
    const QImage after = view_->grab().toImage();
    EXPECT_FALSE(isGreen(after.pixel(after.width() / 4, after.height() / 4)));
}

TEST_F(TreeViewTest, TellsThatItIsSeenFromElsewhere)
{
    settle();
    int reported = 0;
    QObject::connect(view_.get(), &ui::TreeView::cameraChanged, [&reported] { ++reported; });
    const core::ParallelProjection before = view_->scene().projection(10000);
    QTest::keyClick(view_.get(), Qt::Key_Left);
    EXPECT_TRUE(QTest::qWaitFor([&reported] { return reported > 0; }, patienceMs));
    const core::ParallelProjection after = view_->scene().projection(10000);
    EXPECT_LT(before.right.dot(after.right), 0.99);
    EXPECT_NEAR(after.toViewer().norm(), 1.0, 1e-9);
    settle();
    reported = 0;
    view_->requestRender();   // from the same viewpoint
    settle();
    EXPECT_EQ(reported, 0);
}

}   // namespace
