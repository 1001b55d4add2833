#include "ui/views/angiogram_view.h"

#include "tests/ui/overlay_fixture.h"
#include "ui/views/tools/bind_tool.h"
#include "ui/views/tools/nudge_tool.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QBackingStore>
#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <climits>
#include <cmath>

using namespace angiopose;

namespace {

class AngiogramViewTest : public ::testing::TestWithParam<test::Mirror> {
protected:
    AngiogramViewTest()
    {
        view_->resize(640, 480);
        view_->setFrame(core::ImageF(512, 512, 0.0F));
        view_->setWindowLevel(1.0, 0.5);
        view_->scene().setTree(test::treeOfDots());
        setMirror(test::Mirror::SeenFromDetector);
        view_->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(view_.get()));
    }

    void setMirror(test::Mirror mirror)
    {
        camera_ = test::obliqueCamera(mirror);
        view_->setCamera(camera_);
        view_->setPose(test::obliquePose());
        view_->setPivot(Eigen::Vector3d::Zero());
    }
    Eigen::Vector2d projected(const Eigen::Vector3d& pointInPatient) const
    {
        return *core::project(camera_, test::obliquePose() * pointInPatient);
    }
    QPoint onWidget(const Eigen::Vector3d& pointInPatient) const
    {
        return view_->widgetFromImage(projected(pointInPatient)).toPoint();
    }
    void expectDotsWhereProjected()
    {
        const QImage picture = view_->grab().toImage();
        const double ratio = view_->devicePixelRatio();
        const auto brightness = [&picture](int x, int y) {
            return picture.valid(x, y) ? qGray(picture.pixel(x, y)) : 0;
        };
        int seen = 0;
        for (const core::VesselBranch& branch : test::treeOfDots().branches) {
            const QPointF at = view_->widgetFromImage(projected(branch.pointsInPatient.front()));
            // Pixel k of the framebuffer covers k … k + 1 device px.
            const Eigen::Vector2d expected(at.x() * ratio - 0.5, at.y() * ratio - 0.5);
            if (!picture.rect().adjusted(20, 40, -20, -90).contains(at.toPoint() * ratio)) {
                continue;   // outside the image or below the texts
            }
            ++seen;
            EXPECT_LT((test::centerOfLight(brightness, expected) - expected).norm(), 0.5) << "branch " << branch.id;
        }
        EXPECT_GT(seen, 0);
    }
    void drag(Qt::MouseButton button, const QPoint& from, const std::vector<QPoint>& way)
    {
        QTest::mousePress(view_.get(), button, {}, from);
        for (const QPoint& point : way) {
            QTest::mouseMove(view_.get(), point);
        }
    }
    void wheel(int degrees8, Qt::KeyboardModifiers modifiers, const QPointF& at)
    {
        QWheelEvent event(at, view_->mapToGlobal(at), {}, {0, degrees8}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(view_.get(), &event);
    }

    std::unique_ptr<ui::AngiogramView> view_ = std::make_unique<ui::AngiogramView>();
    core::ProjectionCamera camera_;
};

TEST_P(AngiogramViewTest, ShowsThePointsWhereTheCameraProjectsThem)
{
    setMirror(GetParam());
    expectDotsWhereProjected();
    wheel(240, Qt::ControlModifier, {400.0, 300.0});
    expectDotsWhereProjected();
    drag(Qt::MiddleButton, {300, 200}, {{310, 205}, {263, 231}});
    QTest::mouseRelease(view_.get(), Qt::MiddleButton, {}, {263, 231});
    expectDotsWhereProjected();
}

INSTANTIATE_TEST_SUITE_P(BothMirrors, AngiogramViewTest,
                         ::testing::Values(test::Mirror::SeenFromDetector, test::Mirror::SeenFromSource));

TEST_P(AngiogramViewTest, SeenFromTheSourceEverythingLiesMirrored)
{
    setMirror(GetParam());
    const Eigen::Vector2d inside(200.0, 300.0);
    const QPointF before = view_->widgetFromImage(inside);
    view_->setFromSource(true);
    EXPECT_NEAR(view_->widgetFromImage(inside).x(), view_->width() - before.x(), 1e-9);
    EXPECT_NEAR(view_->widgetFromImage(inside).y(), before.y(), 1e-9);
    expectDotsWhereProjected();
    wheel(120, Qt::ControlModifier, {411.0, 173.0});
    expectDotsWhereProjected();
}

using AngiogramViewInput = AngiogramViewTest;

TEST_F(AngiogramViewInput, LeftDragChangesWindowAndLevel)
{
    QSignalSpy changed(view_.get(), &ui::AngiogramView::windowLevelChanged);
    drag(Qt::LeftButton, {100, 100}, {{160, 100}});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, {160, 100});
    ASSERT_FALSE(changed.isEmpty());
    EXPECT_GT(view_->shownRange().window(), 1.0);
    EXPECT_NEAR(view_->shownRange().level(), 0.5, 1e-9);
}

TEST_F(AngiogramViewInput, ControlWheelKeepsThePointUnderTheMouse)
{
    const QPointF mouse(411.0, 173.0);
    const Eigen::Vector2d before = view_->imageFromWidget(mouse);
    const double zoom = view_->zoom();
    wheel(120, Qt::ControlModifier, mouse);
    EXPECT_GT(view_->zoom(), zoom);
    EXPECT_LT((view_->imageFromWidget(mouse) - before).norm(), 1e-9);
    view_->fitToWindow();
    EXPECT_NEAR(view_->zoom(), zoom, 1e-12);
}

TEST_F(AngiogramViewInput, WheelAndKeysStepThroughFrames)
{
    QSignalSpy steps(view_.get(), &ui::AngiogramView::frameStepRequested);
    wheel(-120, {}, {200.0, 200.0});
    wheel(60, {}, {200.0, 200.0});
    wheel(60, {}, {200.0, 200.0});
    QTest::keyClick(view_.get(), Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(view_.get(), Qt::Key_Home);
    QTest::keyClick(view_.get(), Qt::Key_End);
    std::vector<int> values;
    for (const QList<QVariant>& step : steps) {
        values.push_back(step.front().toInt());
    }
    EXPECT_EQ(values, (std::vector<int>{1, -1, 10, INT_MIN, INT_MAX}));
}

TEST_F(AngiogramViewInput, ClickPicksTheBranchAndHoverAnnouncesIt)
{
    int clicked = 0;
    std::optional<int> hovered;
    QObject::connect(view_.get(), &ui::AngiogramView::branchClicked, [&clicked](int id) { clicked = id; });
    QObject::connect(view_.get(), &ui::AngiogramView::branchHovered, [&hovered](auto id) { hovered = id; });
    QSignalSpy background(view_.get(), &ui::AngiogramView::backgroundClicked);
    const core::VesselBranch branch = test::treeOfDots().branches[5];
    const QPoint at = onWidget(branch.pointsInPatient.front());
    QTest::mouseMove(view_.get(), at);
    EXPECT_TRUE(QTest::qWaitFor([&] { return hovered == branch.id; }));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at);
    EXPECT_EQ(clicked, branch.id);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, {5, 5});
    EXPECT_EQ(background.size(), 1);
    EXPECT_EQ(hovered, std::nullopt);
}

TEST_F(AngiogramViewInput, NudgeDragFollowsTheMouseOnTheImage)
{
    ui::NudgeTool nudge(*view_);
    view_->setTool(&nudge);
    core::PoseOffset offset;
    QObject::connect(&nudge, &ui::NudgeTool::dragged, [&](const core::PoseOffset& o) {
        offset = o;
        view_->setPose(core::applyOffset(test::obliquePose(), o, Eigen::Vector3d::Zero(), camera_));
    });
    QSignalSpy finished(&nudge, &ui::NudgeTool::dragFinished);
    const QPoint start = onWidget(Eigen::Vector3d::Zero());
    drag(Qt::LeftButton, start, {start + QPoint(10, 0), start + QPoint(40, -25)});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, start + QPoint(40, -25));
    EXPECT_EQ(finished.size(), 1);
    const auto moved =
        core::applyOffset(test::obliquePose(), offset, Eigen::Vector3d::Zero(), camera_) * Eigen::Vector3d::Zero();
    const Eigen::Vector2d step = (*core::project(camera_, moved) - projected(Eigen::Vector3d::Zero())) * view_->zoom();
    EXPECT_NEAR(step.x(), 40.0, 1e-6);
    EXPECT_NEAR(step.y(), -25.0, 1e-6);
}

TEST_F(AngiogramViewInput, DraggingTheRingRollsClockwise)
{
    ui::NudgeTool nudge(*view_);
    view_->setTool(&nudge);
    core::PoseOffset offset;
    QObject::connect(&nudge, &ui::NudgeTool::dragged, [&](const core::PoseOffset& o) { offset = o; });
    const double radius = 0.12 * view_->height();
    const QPointF center = view_->widgetFromImage(projected(Eigen::Vector3d::Zero()));
    const auto onRing = [&](double rad) { return (center + radius * QPointF(std::cos(rad), std::sin(rad))).toPoint(); };
    drag(Qt::LeftButton, onRing(0.0), {onRing(0.2), onRing(0.5), onRing(0.8)});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, onRing(0.8));
    EXPECT_NEAR(offset.rollDeg, 0.8 * 57.2958, 2.0);   // the mouse moves in whole pixels
    EXPECT_EQ(offset.rightMm, 0.0);
}

/// Each handle around the ring changes its own degree of freedom, in the same direction as the arrow keys.
TEST_F(AngiogramViewInput, TheHandlesAroundTheRingTurnAndMoveInDepth)
{
    ui::NudgeTool nudge(*view_);
    view_->setTool(&nudge);
    core::PoseOffset offset;
    QObject::connect(&nudge, &ui::NudgeTool::dragged, [&](const core::PoseOffset& o) { offset = o; });
    const double outer = 0.12 * view_->height() + ui::outerHandleGapPx;
    const QPointF center = view_->widgetFromImage(projected(Eigen::Vector3d::Zero()));
    const auto dragFrom = [&](const QPointF& from, const QPointF& way) {
        offset = {};
        const QPoint start = (center + from).toPoint();
        drag(Qt::LeftButton, start, {start + (0.5 * way).toPoint(), start + way.toPoint()});
        QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, start + way.toPoint());
    };
    dragFrom({0.0, outer}, {20.0, 0.0});
    EXPECT_NEAR(offset.laoRaoDeg, 20.0 / outer * 57.2958, 0.5);
    dragFrom({outer, 0.0}, {0.0, -20.0});
    EXPECT_NEAR(offset.craCauDeg, 20.0 / outer * 57.2958, 0.5);
    dragFrom({-outer, 0.0}, {0.0, -20.0});
    EXPECT_GT(offset.alongRayMm, 1.0);
    core::PoseOffset depthAlone;
    depthAlone.alongRayMm = offset.alongRayMm;
    EXPECT_EQ(offset, depthAlone);
    dragFrom({outer + 60.0, 0.0}, {0.0, -20.0});
    EXPECT_GT(offset.upMm, 0.1);   // off the handles: a shift
    EXPECT_EQ(offset.craCauDeg, 0.0);
}

TEST_F(AngiogramViewInput, EscapeAndRightClickTakeADragBack)
{
    ui::NudgeTool nudge(*view_);
    view_->setTool(&nudge);
    QSignalSpy cancelled(&nudge, &ui::NudgeTool::dragCancelled);
    QSignalSpy finished(&nudge, &ui::NudgeTool::dragFinished);
    QSignalSpy dragged(&nudge, &ui::NudgeTool::dragged);
    const QPoint start = onWidget(Eigen::Vector3d::Zero());
    drag(Qt::LeftButton, start, {start + QPoint(20, 0)});
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    const auto count = dragged.size();
    QTest::mouseMove(view_.get(), start + QPoint(60, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, start + QPoint(60, 0));
    EXPECT_EQ(cancelled.size(), 1);
    EXPECT_EQ(dragged.size(), count);
    drag(Qt::LeftButton, start, {start + QPoint(20, 0)});
    QTest::mousePress(view_.get(), Qt::RightButton, {}, start + QPoint(20, 0));
    QTest::mouseRelease(view_.get(), Qt::RightButton, {}, start + QPoint(20, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, start + QPoint(20, 0));
    EXPECT_EQ(cancelled.size(), 2);
    EXPECT_EQ(finished.size(), 0);
}

TEST_F(AngiogramViewInput, ManyChangesMakeOneRedraw)
{
    QTest::qWait(50);
    const int before = view_->renderCount();
    for (int i = 0; i < 20; ++i) {
        view_->setPose(test::obliquePose());
    }
    QTest::qWait(200);
    EXPECT_LE(view_->renderCount() - before, 2);
}

/// Color in the window's backing store at a position of the view.
QColor onScreen(const QWidget& view, const QPoint& at)
{
    const auto* buffer = static_cast<QImage*>(view.backingStore()->paintDevice());
    return buffer->pixelColor((view.mapTo(view.window(), at) * view.devicePixelRatio()));
}

TEST_F(AngiogramViewInput, PaintingTheWindowDrawsNothingAgain)
{
    QTest::qWait(50);
    const int before = view_->renderCount();
    view_->window()->repaint();
    view_->update();
    QTest::qWait(50);
    EXPECT_EQ(view_->renderCount(), before);
    view_->setPose(test::obliquePose());
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_->renderCount() > before; }));
}

TEST_F(AngiogramViewInput, WhatWasShownBeforeItWasHiddenIsNotSeenAgain)
{
    auto host = std::make_unique<QWidget>();
    host->resize(700, 500);
    view_->setParent(host.get());
    view_->show();
    host->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(host.get()));
    const QPoint corner(200, 5);
    view_->setFrame(core::ImageF(512, 512, 1.0F));
    ASSERT_TRUE(QTest::qWaitFor([&] { return onScreen(*view_, corner).lightness() > 200; }));
    view_->hide();
    view_->setFrame(core::ImageF(512, 512, 0.0F));
    view_->show();
    host->repaint();   // before the view updates itself
    EXPECT_LT(onScreen(*view_, corner).lightness(), 50);
    view_->setFrame(core::ImageF(512, 512, 1.0F));
    EXPECT_TRUE(QTest::qWaitFor([&] { return onScreen(*view_, corner).lightness() > 200; }));
    view_.reset();
}

TEST_F(AngiogramViewInput, MovesToAnotherWindow)
{
    auto host = std::make_unique<QWidget>();
    host->resize(700, 500);
    auto* layout = new QVBoxLayout(host.get());
    layout->addWidget(view_.get());
    host->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(host.get()));
    expectDotsWhereProjected();
    view_.reset();
}

}   // namespace
