// What gives room and takes it back: words in other languages, sentences and plots that come and go.
#include "ui/panels/result_panel.h"
#include "ui/words/spoken.h"

#include <gtest/gtest.h>
#include <QComboBox>
#include <QTest>

#include <functional>

namespace angiopose::ui {
namespace {

/// A pose moved by hand of which so many sentences are told.
JudgedPose moved(std::size_t sentences)
{
    JudgedPose judged;
    judged.source = PoseSource::Edited;
    judged.residualsMm = {0.5, 1.0};
    judged.scaleMaximumMm = 2.0;
    judged.result.trustworthy = false;
    judged.result.warnings.assign(sentences,
                                  core::Message::verbatim("A sentence that takes a line or two of the card."));
    return judged;
}

/// As high as a panel that never showed anything else.
int heightNeeded(const std::function<void(ResultPanel&)>& show)
{
    ResultPanel fresh;
    fresh.setFixedWidth(300);
    fresh.show();
    show(fresh);
    QTest::qWait(50);
    return fresh.minimumSizeHint().height();
}

TEST(ResultPanel, KeepsRoomWhileAPoseIsMovedAndGivesItBackAtRest)
{
    ResultPanel panel;
    panel.setFixedWidth(300);
    panel.show();
    panel.showJudgement(moved(5), {});
    QTest::qWait(50);
    const int full = panel.minimumSizeHint().height();
    panel.showJudgement(moved(1), {});
    QTest::qWait(50);
    EXPECT_EQ(panel.minimumSizeHint().height(), full);   // nothing below moves under the hand
    const int needed = heightNeeded([](ResultPanel& fresh) { fresh.showJudgement(moved(1), {}); });
    ASSERT_LT(needed, full);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.minimumSizeHint().height() == needed; }, 5000));
}

TEST(ResultPanel, PlotsGiveTheirRoomBack)
{
    ResultPanel panel;
    panel.setFixedWidth(300);
    panel.show();
    panel.showJudgement(moved(0), {});
    panel.showHistory(std::vector<core::IterationReport>(2));
    QTest::qWait(50);
    const int full = panel.minimumSizeHint().height();
    panel.showNothing(QStringLiteral("nothing"));
    panel.showHistory({});
    QTest::qWait(50);
    EXPECT_EQ(panel.minimumSizeHint().height(), full);
    const int needed = heightNeeded([](ResultPanel& fresh) { fresh.showNothing(QStringLiteral("nothing")); });
    ASSERT_LT(needed, full);
    EXPECT_TRUE(QTest::qWaitFor([&] { return panel.minimumSizeHint().height() == needed; }, 5000));
}

TEST(Words, AChoiceIsAsNarrowAsItsWordsOnceLongerOnesAreGone)
{
    QComboBox box;
    box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
    setWords(box, {QStringLiteral("by name"), QStringLiteral("by length")});
    box.show();
    const int leastPx = box.minimumSizeHint().width();
    setWords(box, {QStringLiteral("nach dem Namen der Gefäße"), QStringLiteral("nach der Länge")});
    ASSERT_GT(box.minimumSizeHint().width(), leastPx);
    setWords(box, {QStringLiteral("by name"), QStringLiteral("by length")});
    EXPECT_EQ(box.minimumSizeHint().width(), leastPx);
}

}   // namespace
}   // namespace angiopose::ui
