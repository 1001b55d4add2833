#include "ui/views/tree_view.h"

#include "tests/ui/overlay_fixture.h"

#include <gtest/gtest.h>
#include <QImage>
#include <QTest>
#include <QVBoxLayout>

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

/// Pixels that are clearly brighter than the ground.
int brightPixels(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            count += qGray(picture.pixel(x, y)) > 110;
        }
    }
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
    /// Until the view has drawn, and has had nothing more to draw for half a second.
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
    EXPECT_LT(turned, 0.9 * inWide) << "what was turned by hand is not framed anew";
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

}   // namespace
