// Layout space that is claimed and released again: text in other languages, sentences and plots that appear and
// disappear.
#include "ui/panels/result_panel.h"
#include "ui/plots/convergence_plot.h"
#include "ui/plots/histogram_plot.h"
#include "ui/words/retranslation.h"

#include <gtest/gtest.h>
#include <QComboBox>
#include <QLabel>
#include <QTest>

namespace angiopose::ui {
namespace {

/// A manually moved pose with the given number of messages.
AssessedPose moved(std::size_t sentences)
{
    AssessedPose judged;
    judged.source = PoseSource::Edited;
    judged.residualsMm = {0.5, 1.0};
    judged.scaleMaximumMm = 2.0;
    judged.result.trustworthy = false;
    judged.result.warnings.assign(sentences,
                                  core::Message::verbatim("A sentence that takes a line or two of the card."));
    return judged;
}

/// Minimum height reserved for the sentences, shown or not.
int keptHeight(const ResultPanel& panel)
{
    int height = 0;
    for (const QLabel* label : panel.findChildren<QLabel*>()) {
        height += label->wordWrap() ? label->minimumHeight() : 0;
    }
    return height;
}

TEST(ResultPanel, KeepsRoomWhileAPoseIsMovedAndGivesItBackAtRest)
{
    ResultPanel panel;
    panel.setFixedWidth(300);
    panel.show();
    panel.showAssessment(moved(5), {});
    QTest::qWait(50);
    EXPECT_EQ(keptHeight(panel), 0);
    panel.showAssessment(moved(1), {});
    EXPECT_GT(keptHeight(panel), 0);   // nothing below moves under the mouse pointer
    EXPECT_TRUE(QTest::qWaitFor([&] { return keptHeight(panel) == 0; }, 5000));
}

TEST(ResultPanel, PlotsGiveTheirRoomBack)
{
    ResultPanel panel;
    const auto& histogram = *panel.findChild<HistogramPlot*>();
    const auto& convergence = *panel.findChild<ConvergencePlot*>();
    const int empty = histogram.minimumHeight();
    panel.showAssessment(moved(0), {});
    panel.showHistory(std::vector<core::IterationReport>(2));
    const int full = histogram.minimumHeight();
    ASSERT_GT(full, empty);
    panel.showNothing(QStringLiteral("nothing"));
    panel.showHistory({});
    EXPECT_EQ(histogram.minimumHeight(), full);
    EXPECT_GT(convergence.minimumHeight(), full);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return histogram.minimumHeight() == empty && convergence.minimumHeight() == empty; }, 5000));
}

TEST(Words, AChoiceIsAsNarrowAsItsWordsOnceLongerOnesAreGone)
{
    QComboBox box;
    box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
    setItemTexts(box, {QStringLiteral("by name"), QStringLiteral("by length")});
    box.show();
    const int minPx = box.minimumSizeHint().width();
    setItemTexts(box, {QStringLiteral("nach dem Namen der Gefäße"), QStringLiteral("nach der Länge")});
    ASSERT_GT(box.minimumSizeHint().width(), minPx);
    setItemTexts(box, {QStringLiteral("by name"), QStringLiteral("by length")});
    EXPECT_EQ(box.minimumSizeHint().width(), minPx);
}

}   // namespace
}   // namespace angiopose::ui
