#include "core/registration/options/option_fields.h"
#include "ui/panels/geometry_panel.h"
#include "ui/panels/lock_button.h"
#include "ui/panels/option_form.h"
#include "ui/panels/pose_panel.h"
#include "ui/panels/registration_panel.h"
#include "ui/plots/frame_bars.h"
#include "ui/plots/histogram_plot.h"

#include <gtest/gtest.h>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

namespace angiopose::ui {
namespace {

TEST(PosePanel, ReportsTheWholeOffsetAfterTyping)
{
    PosePanel panel;
    core::PoseOffset reported;
    QObject::connect(&panel, &PosePanel::offsetEdited, [&](const core::PoseOffset& offset) { reported = offset; });
    panel.showOffset(core::PoseOffset{.rightMm = 1.0, .rollDeg = 2.0});
    auto* up = panel.findChildren<NumberField*>()[1];

    up->selectAll();
    QTest::keyClicks(up, QStringLiteral("4"));
    QTest::keyClick(up, Qt::Key_Return);

    EXPECT_EQ(reported, (core::PoseOffset{.rightMm = 1.0, .upMm = 4.0, .rollDeg = 2.0}));
}

TEST(PosePanel, ShowsAtOnceThatALockedValueCannotBeTyped)
{
    PosePanel panel;
    panel.showOffset(core::PoseOffset{});
    panel.show();
    auto* field = panel.findChild<NumberField*>();
    const QImage open = field->grab().toImage();
    panel.showLocks({true});
    const QImage locked = field->grab().toImage();
    EXPECT_NE(locked, open);
    field->setEnabled(false);   // the appearance of a disabled field
    EXPECT_EQ(locked, field->grab().toImage());
}

TEST(PosePanel, WhatIsLockedKeepsNoMarkedText)
{
    PosePanel panel;
    panel.showOffset(core::PoseOffset{});
    auto* field = panel.findChild<NumberField*>();
    field->selectAll();
    ASSERT_TRUE(field->hasSelectedText());
    PoseLocks locks{};
    locks.fill(true);
    panel.showLocks(locks);
    EXPECT_FALSE(field->hasSelectedText());
}

TEST(PosePanel, TogglesALockByItsDot)
{
    PosePanel panel;
    panel.showOffset(core::PoseOffset{});
    PoseLocks reported{};
    QObject::connect(&panel, &PosePanel::locksEdited, [&](const PoseLocks& locks) { reported = locks; });

    QTest::mouseClick(panel.findChildren<LockButton*>()[2], Qt::LeftButton);

    EXPECT_EQ(reported, (PoseLocks{false, false, true, false, false, false}));
}

TEST(RegistrationPanel, ShowsTheOptionsOfTheChosenMethodSilently)
{
    RegistrationPanel panel;
    QSignalSpy edited(&panel, &RegistrationPanel::optionsEdited);
    core::RegistrationOptions options;
    options.method = "dynaweight";
    panel.showOptions(options);
    EXPECT_EQ(edited.count(), 0);
    for (const core::OptionField& field : core::optionFields()) {
        const bool applies = core::appliesTo(field, "dynaweight");
        EXPECT_EQ(panel.findChild<QWidget*>(QString::fromUtf8(field.key.data(), static_cast<int>(field.key.size()))) !=
                      nullptr,
                  applies)
            << field.key;
    }
}

TEST(RegistrationPanel, CannotStartWhileRunningOrNotReady)
{
    RegistrationPanel panel;
    EXPECT_TRUE(panel.registerButton()->isEnabled());
    panel.setRunning(true);
    EXPECT_FALSE(panel.registerButton()->isEnabled());
    panel.setRunning(false);
    panel.showBlockingReason(QStringLiteral("Open an angiogram first."));
    EXPECT_FALSE(panel.registerButton()->isEnabled());
    EXPECT_EQ(panel.registerButton()->toolTip(), QStringLiteral("Open an angiogram first."));
}

TEST(GeometryPanel, MarksWhatIsMissingAndReportsItAsTyped)
{
    GeometryPanel panel;
    GeometryState state;
    state.missing = QStringLiteral("SID is missing.");
    panel.showGeometry(state);
    EXPECT_FALSE(panel.isFolded());
    core::CArm reported;
    QObject::connect(&panel, &GeometryPanel::edited, [&](const core::CArm& cArm) { reported = cArm; });
    auto* sid = panel.findChildren<NumberField*>()[0];

    QTest::keyClicks(sid, QStringLiteral("950"));
    QTest::keyClick(sid, Qt::Key_Return);

    EXPECT_DOUBLE_EQ(reported.sourceToDetectorMm.value.value_or(0.0), 950.0);
    EXPECT_EQ(reported.sourceToDetectorMm.origin, core::Origin::User);
}

TEST(FrameBars, AskForTheFrameUnderTheMouse)
{
    FrameBars bars;
    bars.resize(400, 40);
    bars.showFrames({{0.1, 0.5, 1.0, 0.7}, 2, 0.0});
    bars.showCurrent(2);
    QSignalSpy requested(&bars, &FrameBars::frameRequested);

    QTest::mouseClick(&bars, Qt::LeftButton, Qt::NoModifier, QPoint(350, 20));
    QTest::keyClick(&bars, Qt::Key_Left);

    ASSERT_EQ(requested.count(), 2);
    EXPECT_EQ(requested.at(0).first().toInt(), 3);
    EXPECT_EQ(requested.at(1).first().toInt(), 1);
}

TEST(FrameBars, ShiftMarksMaskFrames)
{
    FrameBars bars;
    bars.resize(400, 40);
    bars.showFrames({{0.0, 0.1, 1.0, 0.7}, 2, 66.7});
    bars.showCurrent(0);
    QSignalSpy marked(&bars, &FrameBars::maskRangeMarked);
    QSignalSpy requested(&bars, &FrameBars::frameRequested);

    QTest::mousePress(&bars, Qt::LeftButton, Qt::ShiftModifier, QPoint(250, 20));
    QTest::mouseMove(&bars, QPoint(50, 20));
    QTest::mouseRelease(&bars, Qt::LeftButton, Qt::ShiftModifier, QPoint(50, 20));
    ASSERT_EQ(marked.count(), 1);
    EXPECT_EQ(marked.at(0), (QVariantList{0, 2})) << "backwards as well";
    EXPECT_EQ(requested.count(), 0);

    QTest::keyClick(&bars, Qt::Key_Right, Qt::ShiftModifier);
    ASSERT_EQ(marked.count(), 2);
    EXPECT_EQ(marked.at(1), (QVariantList{0, 1}));
}

TEST(FrameBars, TellFrameTimeAndWhatIsSpecial)
{
    const FrameCurve curve{{0.0, 0.1, 1.0}, 2, 66.7};
    EXPECT_EQ(describeFrame(curve, {0, 1}, 1), QStringLiteral("Frame 2 · 0.07 s · 10 % · mask"));
    EXPECT_EQ(describeFrame(curve, {}, 2), QStringLiteral("Frame 3 · 0.13 s · 100 % · peak-opacification frame"));
}

TEST(FrameBars, RWavesAreSeenAndNamed)
{
    FrameCurve curve{{0.0, 0.1, 1.0, 0.7}, 2, 66.7};
    FrameBars bars;
    bars.resize(400, 44);
    bars.showFrames(curve);
    bars.showLoop({0, 3});
    const QImage without = bars.grab().toImage();
    curve.rWaves = {1};
    bars.showFrames(curve);
    EXPECT_NE(bars.grab().toImage(), without);
    EXPECT_EQ(describeFrame(curve, {}, 1), QStringLiteral("Frame 2 · 0.07 s · 10 % · R wave"));
}

TEST(HistogramPlot, CountsWhatLiesAboveTheScaleByItself)
{
    const auto counts =
        histogramCounts({0.0, 0.4, 0.6, 1.9, 2.0, 50.0, std::numeric_limits<double>::infinity()}, 2.0, 4);
    EXPECT_EQ(counts, (std::vector<int>{2, 1, 0, 1, 3}));
}

}   // namespace
}   // namespace angiopose::ui
