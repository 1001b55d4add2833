#include "app/document/edit_case.h"
#include "core/tracing/angiogram/drawing/edit_centerline.h"
#include "io/case/case_file.h"
#include "io/edited_curves.h"
#include "tests/app/open_window.h"
#include "tests/app/session/words_of_window.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/curve_edit_bar.h"
#include "ui/words/message_text.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Fixture: the sample with its frame traced and curve editing active.
class WindowCurves : public ::testing::Test {
protected:
    void SetUp() override
    {
        w.openSample();
        ASSERT_TRUE(test::waitFor([this] { return target() != nullptr; }));
        traced = *target();
        ASSERT_FALSE(traced.curves.empty());
        w.press(Qt::Key_E);
        ASSERT_EQ(w.window.angiogramView().tool(), &tool());
    }

    ui::EditCurvesTool& tool() { return w.controller.angiogram().curves().tool(); }
    const SharedCenterline& target() { return w.controller.target().current(); }
    QPoint onScreen(const Eigen::Vector2d& imagePx)
    {
        return w.window.angiogramView().widgetFromImage(imagePx).toPoint();
    }
    void clickAt(const Eigen::Vector2d& imagePx)
    {
        QTest::mouseMove(&w.window.angiogramView(), onScreen(imagePx));
        QTest::mouseClick(&w.window.angiogramView(), Qt::LeftButton, {}, onScreen(imagePx));
    }
    void dragBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Qt::KeyboardModifiers modifiers = {})
    {
        QWidget* view = &w.window.angiogramView();
        QTest::mousePress(view, Qt::LeftButton, modifiers, onScreen(from));
        QTest::mouseMove(view, onScreen(0.5 * (from + to)));
        QTest::mouseMove(view, onScreen(to));
        QTest::mouseRelease(view, Qt::LeftButton, modifiers, onScreen(to));
    }
    /// A curve without other curves near its middle.
    const core::Curve2d& loneCurve() const
    {
        return *std::ranges::max_element(traced.curves, {}, &core::Curve2d::lengthPx);
    }
    static Eigen::Vector2d middle(const core::Curve2d& curve) { return curve.pointsPx[curve.pointsPx.size() / 2]; }

    OpenWindow w;
    core::Centerline2d traced;
};

TEST_F(WindowCurves, AClickLeavesACurveOutAsOneStep)
{
    const int id = core::curveAt(traced, middle(loneCurve()), 5.0);
    clickAt(middle(loneCurve()));

    ASSERT_TRUE(w.current().shown().target.centerline);
    EXPECT_EQ(w.current().shown().target.centerline->curves.size(), traced.curves.size() - 1);
    EXPECT_EQ(std::ranges::count(w.current().shown().target.centerline->curves, id, &core::Curve2d::id), 0);
    EXPECT_EQ(w.current().shown().target.editedFrame, w.current().shown().frame);
    EXPECT_EQ(target()->curves.size(), traced.curves.size() - 1) << "what is registered to";
    EXPECT_EQ(w.history().count(), 1);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Mark as non-vessel"));
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(w.current().shown().target.centerline);
    EXPECT_EQ(target()->pointCount(), traced.pointCount());
}

/// The pose is still that of the registration, but the trace to which it was fitted has changed.
TEST_F(WindowCurves, APoseOfARunIsNotCalledMovedByHandWhenTheTraceChanges)
{
    w.press(Qt::Key_Escape);
    w.registerVessels();
    ASSERT_TRUE(w.current().shown().result);
    traced = *target();
    w.press(Qt::Key_E);
    clickAt(middle(loneCurve()));
    ASSERT_FALSE(w.current().shown().result);
    const auto says = [this](const QString& words) {
        return std::ranges::any_of(w.window.result().findChildren<QLabel*>(), [&words](const QLabel* label) {
            return label->isVisible() && label->text().contains(words);
        });
    };
    EXPECT_TRUE(test::waitFor([&] { return says(QStringLiteral("an earlier registration")); }));
    EXPECT_FALSE(says(QStringLiteral("moved manually")));
}

TEST_F(WindowCurves, TheBrushErasesAndEscapeTakesTheStrokeBack)
{
    const Eigen::Vector2d at = middle(loneCurve());
    w.press(Qt::Key_E);
    QWidget* view = &w.window.angiogramView();
    QTest::mousePress(view, Qt::LeftButton, {}, onScreen(at));
    QTest::mouseMove(view, onScreen(at) + QPoint(12, 0));
    w.press(Qt::Key_Escape);
    QTest::mouseRelease(view, Qt::LeftButton, {}, onScreen(at) + QPoint(12, 0));
    EXPECT_EQ(w.history().count(), 0);
    EXPECT_EQ(w.window.angiogramView().tool(), &tool()) << "the stroke, not the mode";

    dragBetween(at - Eigen::Vector2d(10.0, 0.0), at + Eigen::Vector2d(10.0, 0.0));
    EXPECT_EQ(w.history().count(), 1);
    EXPECT_LT(target()->pointCount(), traced.pointCount());
    EXPECT_EQ(core::curveAt(*target(), at, 3.0), -1);
}

TEST_F(WindowCurves, DrawsBackWhatWasErased)
{
    const core::Curve2d curve = loneCurve();
    clickAt(middle(curve));
    ASSERT_EQ(w.history().count(), 1);
    ASSERT_TRUE(test::waitFor([this] { return tool().hasGuide(); }));
    w.press(Qt::Key_D);
    const auto count = curve.pointsPx.size();
    clickAt(curve.pointsPx[count / 4]);
    clickAt({5.0, 5.0});   // a wrong click
    w.press(Qt::Key_Backspace);
    clickAt(curve.pointsPx[3 * count / 4]);
    w.press(Qt::Key_Return);

    ASSERT_EQ(w.history().count(), 2);
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Draw a curve"));
    const core::Curve2d& drawn = target()->curves.back();
    for (const Eigen::Vector2d& point : drawn.pointsPx) {
        EXPECT_NE(core::curveAt(traced, point, 4.0), -1) << "beside every vessel: " << point.transpose();
    }
    EXPECT_GT(drawn.lengthPx(), 0.3 * curve.lengthPx());
}

TEST_F(WindowCurves, CutsAndRestricts)
{
    w.press(Qt::Key_C);
    clickAt(middle(loneCurve()));
    EXPECT_EQ(target()->curves.size(), traced.curves.size() + 1);
    EXPECT_EQ(target()->pointCount(), traced.pointCount());

    w.press(Qt::Key_B);
    const Eigen::Vector2d at = middle(loneCurve());
    dragBetween(at - Eigen::Vector2d(30.0, 30.0), at + Eigen::Vector2d(30.0, 30.0));
    const std::size_t outside = target()->pointCount();
    EXPECT_LT(outside, traced.pointCount()) << "what lies inside goes, all else stays";
    EXPECT_GT(outside, traced.pointCount() / 2);
    w.press(Qt::Key_Z, Qt::ControlModifier);
    dragBetween(at - Eigen::Vector2d(30.0, 30.0), at + Eigen::Vector2d(30.0, 30.0), Qt::ControlModifier);
    EXPECT_NEAR(static_cast<double>(target()->pointCount() + outside), static_cast<double>(traced.pointCount()), 4.0);
    EXPECT_EQ(w.history().count(), 2);
}

TEST_F(WindowCurves, EscapeEndsTheModeAndTheKeysAreTheWindowsAgain)
{
    w.press(Qt::Key_D);
    clickAt(middle(loneCurve()));
    w.press(Qt::Key_Escape);
    EXPECT_EQ(w.window.angiogramView().tool(), &tool()) << "first the path under way";
    w.press(Qt::Key_Escape);
    EXPECT_EQ(w.window.angiogramView().tool(), nullptr);
    EXPECT_FALSE(w.window.actions()[ui::Command::EditVessels]->isChecked());
    EXPECT_EQ(w.history().count(), 0);
    w.press(Qt::Key_N);
    EXPECT_TRUE(w.window.actions()[ui::Command::Nudge]->isChecked());
    w.press(Qt::Key_E);
    EXPECT_FALSE(w.window.actions()[ui::Command::Nudge]->isChecked()) << "one mode at a time";
}

TEST_F(WindowCurves, TracesAgainWhenAskedTwice)
{
    clickAt(middle(loneCurve()));
    w.window.actions()[ui::Command::TraceAgain]->trigger();
    ASSERT_EQ(w.dialogs("traceAgainQuestion").size(), 1);
    OpenWindow::clickButton(w.dialogs("traceAgainQuestion").front(), QStringLiteral("Trace again"));
    EXPECT_FALSE(w.current().shown().target.centerline);
    EXPECT_EQ(target()->pointCount(), traced.pointCount());
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(target()->curves.size(), traced.curves.size() - 1);
}

TEST_F(WindowCurves, EditsHoldForTheirFrame)
{
    clickAt(middle(loneCurve()));
    const SharedCenterline edited = target();
    const int frame = w.current().shown().frame;
    w.press(Qt::Key_Escape);
    w.press(Qt::Key_Up);
    ASSERT_NE(w.current().shown().frame, frame);
    ASSERT_TRUE(test::waitFor([this] { return target() && w.controller.target().trace(); }));
    EXPECT_NE(target(), edited);
    w.press(Qt::Key_Down);
    EXPECT_EQ(target(), edited);
}

TEST_F(WindowCurves, SurviveSavingAndReopening)
{
    clickAt(middle(loneCurve()));
    const test::TemporaryFolder folder;
    const std::string path = folder.file("case.angiopose");
    ASSERT_TRUE(w.saveCase(QString::fromStdString(path)));

    // The command line reads the same target from the file.
    core::Messages warnings;
    const auto loaded = io::loadCase(path, warnings);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const auto same = core::targetOf(loaded.value().shown());
    ASSERT_TRUE(same);
    ASSERT_EQ(same.value().curves.size(), target()->curves.size());
    for (std::size_t i = 0; i < same.value().curves.size(); ++i) {
        EXPECT_EQ(same.value().curves[i].pointsPx, target()->curves[i].pointsPx);
    }
    w.drop({QString::fromStdString(path)});
    EXPECT_EQ(w.current().shown().target.editedFrame, w.current().shown().frame);
}

TEST_F(WindowCurves, AreNamedAlikeBeforeAndAfterSaving)
{
    clickAt(middle(loneCurve()));
    const core::InputFile unsaved = io::exportedFile(w.current().shown().target);
    EXPECT_TRUE(unsaved.path.empty());
    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("case.angiopose"));
    ASSERT_TRUE(w.saveCase(path));
    w.drop({path});
    EXPECT_EQ(io::exportedFile(w.current().shown().target), unsaved);
    EXPECT_EQ(w.current().shown().target.file.sha256, unsaved.sha256);
}

TEST_F(WindowCurves, ACatheterIsKeptApartFollowedAndSaved)
{
    const core::Curve2d device = loneCurve();
    w.press(Qt::Key_W);
    clickAt(middle(device));
    const auto apart = core::devicesOf(w.current().shown());
    ASSERT_TRUE(apart);
    ASSERT_EQ(apart->curves.size(), 1U);
    EXPECT_EQ(apart->curves.front().pointsPx, device.pointsPx);
    EXPECT_EQ(target()->curves.size(), traced.curves.size() - 1) << "what is registered to";
    EXPECT_EQ(w.history().undoText(), QStringLiteral("Mark curve as device"));

    const test::TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("case.angiopose"));
    ASSERT_TRUE(w.saveCase(path));
    w.drop({path});
    ASSERT_TRUE(core::devicesOf(w.current().shown()));
    EXPECT_EQ(core::curveIds(*core::devicesOf(w.current().shown())), std::vector<int>{device.id});
    EXPECT_EQ(target()->curves.size(), traced.curves.size() - 1);

    w.press(Qt::Key_E);
    const auto buttons = w.window.findChild<ui::CurveEditBar*>()->findChildren<QPushButton*>();
    const auto follow = std::ranges::find(buttons, QStringLiteral("Track device"), &QPushButton::text);
    ASSERT_TRUE(follow != buttons.end() && (*follow)->isVisible());
    QTest::mouseClick(*follow, Qt::LeftButton);
    w.waitForRun();
    ASSERT_TRUE(w.current().shown().result);
    EXPECT_EQ(w.current().shown().result->method, "wire");
    EXPECT_FALSE(w.current().shown().result->wirePaths.empty()) << "one line: the catheter alone";
}

TEST_F(WindowCurves, ACatheterTakenBackIsAVesselAndNoSuspect)
{
    w.press(Qt::Key_W);
    clickAt(middle(loneCurve()));
    clickAt(middle(loneCurve()));
    EXPECT_FALSE(core::devicesOf(w.current().shown()));
    EXPECT_EQ(target()->curves.size(), traced.curves.size());
    EXPECT_EQ(w.current().shown().target.acceptedCurveIds, std::vector<int>{loneCurve().id});
    w.press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(core::devicesOf(w.current().shown()));
}

TEST_F(WindowCurves, WhatIsCutOffACatheterStaysApart)
{
    w.press(Qt::Key_W);
    clickAt(middle(loneCurve()));
    w.press(Qt::Key_C);
    clickAt(middle(loneCurve()));
    ASSERT_TRUE(core::devicesOf(w.current().shown()));
    EXPECT_EQ(core::devicesOf(w.current().shown())->curves.size(), 2U);
    EXPECT_EQ(target()->curves.size(), traced.curves.size() - 1);
}

TEST_F(WindowCurves, SayWhyThereAreNoneAsSoonAsThatIsKnown)
{
    core::TraceOptions options = w.current().shown().traceOptions;
    options.minComponentLengthPx = 100000;
    w.controller.document().push(std::make_unique<ChangeTracing>(
        w.controller.document(), ChangeTracing::Values{options, std::nullopt, {}}, [] { return QString(); }));
    ASSERT_TRUE(test::waitFor([this] { return w.controller.target().problem().has_value(); }));
    const QString why = ui::messageText(*w.controller.target().problem());
    EXPECT_TRUE(test::wordsOf(w.window.result()).join(QLatin1Char(' ')).contains(why));
}

TEST_F(WindowCurves, ButtonsChooseTheEdit)
{
    auto* bar = w.window.findChild<ui::CurveEditBar*>();
    ASSERT_TRUE(bar && bar->isVisible());
    for (QToolButton* button : bar->findChildren<QToolButton*>()) {
        QTest::mouseClick(button, Qt::LeftButton);
        EXPECT_TRUE(button->isChecked());
        EXPECT_TRUE(w.window.angiogramView().hasFocus()) << "keys go to the image";
    }
    EXPECT_EQ(tool().edit(), ui::CurveEdit::Lasso);
}

}   // namespace
}   // namespace angiopose::app
