#include "ui/views/tools/edit_curves_tool.h"

#include "ui/views/angiogram_view.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

using namespace angiopose;

namespace {

core::Curve2d lineAt(int id, double y)
{
    core::Curve2d curve;
    curve.id = id;
    for (int x = 50; x < 450; x += 5) {
        curve.pointsPx.emplace_back(x, y);
    }
    return curve;
}

/// Four curves, two of which (3 and 5) may be catheters.
class EditCurvesKeys : public ::testing::Test {
protected:
    EditCurvesKeys()
    {
        view.resize(640, 480);
        view.setFrame(core::ImageF(512, 512, 0.0F));
        view.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&view));
        for (const int id : {2, 3, 4, 5}) {
            curves.curves.push_back(lineAt(id, 60.0 * id));
        }
        tool->showCurves(curves, {.suspects = {3, 5}});
        tool->setReady(true);
        view.setTool(tool);
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }

    ui::AngiogramView view;
    ui::EditCurvesTool* tool = new ui::EditCurvesTool(view);
    core::Centerline2d curves;
    QSignalSpy accepted{tool, &ui::EditCurvesTool::suspectAccepted};
    QSignalSpy edited{tool, &ui::EditCurvesTool::edited};
};

TEST_F(EditCurvesKeys, KeepASuspectApartAndAnyCurveThatIsClicked)
{
    QSignalSpy apart(tool, &ui::EditCurvesTool::deviceToggled);
    press(Qt::Key_S);
    press(Qt::Key_W);
    ASSERT_EQ(apart.count(), 1);
    EXPECT_EQ(apart[0], QVariantList({3, true}));
    tool->showCurves(curves, {.suspects = {}, .devices = {3}});   // as the case responds
    press(Qt::Key_W);   // no suspect is selected: the key sets what a click does
    EXPECT_EQ(tool->edit(), ui::CurveEdit::MarkDevice);
    for (const int id : {4, 3}) {
        const core::Curve2d& curve = *std::ranges::find(curves.curves, id, &core::Curve2d::id);
        QTest::mouseClick(&view, Qt::LeftButton, {},
                          view.widgetFromImage(curve.pointsPx[curve.pointsPx.size() / 2]).toPoint());
    }
    ASSERT_EQ(apart.count(), 3);
    EXPECT_EQ(apart[1], QVariantList({4, true}));
    EXPECT_EQ(apart[2], QVariantList({3, false})) << "taken back";
    EXPECT_EQ(edited.count(), 0);
}

TEST_F(EditCurvesKeys, AcceptASuspectAndGoToTheNext)
{
    press(Qt::Key_A);
    EXPECT_EQ(accepted.count(), 0);   // none is selected yet
    press(Qt::Key_S);
    EXPECT_TRUE(tool->caption().contains(QStringLiteral("catheter")));
    press(Qt::Key_A);
    ASSERT_EQ(accepted.count(), 1);
    EXPECT_EQ(accepted[0][0].toInt(), 3);
    tool->showCurves(curves, {.suspects = {5}});   // as the case responds
    press(Qt::Key_A);
    ASSERT_EQ(accepted.count(), 2);
    EXPECT_EQ(accepted[1][0].toInt(), 5);
    tool->showCurves(curves, {});
    press(Qt::Key_A);
    EXPECT_EQ(accepted.count(), 2);
}

TEST_F(EditCurvesKeys, LeaveASuspectOut)
{
    press(Qt::Key_S, Qt::ShiftModifier);   // the last suspect
    press(Qt::Key_Delete);
    ASSERT_EQ(edited.count(), 1);
    const auto left = edited[0][0].value<core::Centerline2d>();
    ASSERT_EQ(left.curves.size(), 3U);
    EXPECT_EQ(left.curves.back().id, 4);
}

TEST_F(EditCurvesKeys, GoRoundTheSuspects)
{
    for (int i = 0; i < 3; ++i) {
        press(Qt::Key_S);
    }
    press(Qt::Key_A);
    ASSERT_EQ(accepted.count(), 1);
    EXPECT_EQ(accepted[0][0].toInt(), 3);
}

}   // namespace
