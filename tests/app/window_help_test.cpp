#include "tests/app/open_window.h"

#include "app/help/fit_examples.h"
#include "ui/controls/section.h"
#include "ui/help/help_page.h"
#include "ui/help/tour.h"
#include "ui/words/language.h"

#include <QImage>
#include <QLabel>
#include <QTextBrowser>
#include <QTextEdit>

#include <set>

namespace angiopose::app {
namespace {

using test::OpenWindow;

TEST(WindowHelp, WhatWasToldCanBeReadAgain)
{
    test::SampleWindow w;
    w.press(Qt::Key_K);   // stores a snapshot and reports it
    w.drop({QStringLiteral("/nowhere/run.dcm")});
    for (QDialog* message : w.dialogs("messageDialog")) {
        message->close();
    }
    w.window.actions()[ui::Command::Messages]->trigger();
    ASSERT_EQ(w.dialogs("messageHistory").size(), 1);
    const QString reported = w.dialogs("messageHistory").front()->findChild<QTextEdit*>()->toPlainText();
    EXPECT_TRUE(reported.contains(QStringLiteral("Saved as"))) << reported.toStdString();
    EXPECT_TRUE(reported.contains(QStringLiteral("run.dcm"))) << reported.toStdString();
    EXPECT_LT(reported.indexOf(QStringLiteral("Saved as")), reported.indexOf(QStringLiteral("run.dcm")));
}

TEST(WindowHelp, EveryPanelHasAPageInEveryLanguage)
{
    OpenWindow w;
    std::set<QString> pages{QStringLiteral("panels/overview")};
    for (QWidget* widget :
         {static_cast<QWidget*>(&w.window.angiogramView()), static_cast<QWidget*>(&w.window.treeView()),
          static_cast<QWidget*>(&w.window.steps()), static_cast<QWidget*>(&w.window.strip()),
          static_cast<QWidget*>(&w.window.welcome()), static_cast<QWidget*>(&w.window.result())}) {
        pages.insert(ui::HelpPage::pageAbout(widget));
    }
    for (const ui::Section* section : w.window.findChildren<ui::Section*>()) {
        EXPECT_NE(ui::HelpPage::pageAbout(section), QStringLiteral("panels/overview"))
            << section->metaObject()->className();
        pages.insert(ui::HelpPage::pageAbout(section));
    }
    EXPECT_GE(pages.size(), 11U);
    for (const QString& page : pages) {
        std::set<QString> texts;
        for (const QString& language : ui::languages()) {
            ui::applyLanguage(language);
            const QString text = ui::HelpPage::markdown(page);
            EXPECT_TRUE(text.startsWith(QStringLiteral("# "))) << page.toStdString();
            texts.insert(text);
        }
        ui::applyLanguage(QStringLiteral("en"));
        EXPECT_EQ(texts.size(), 3U) << page.toStdString() << " is not translated";
    }
}

TEST(WindowHelp, F1ExplainsThePanelThatHasTheKeysOrTheMouse)
{
    OpenWindow w;
    w.window.branches().setFocus();
    QCursor::setPos(w.window.pose().mapToGlobal(QPoint(40, 40)));
    QTest::qWait(50);
    w.press(Qt::Key_F1);
    const QList<QDialog*> open = w.dialogs("helpPage");
    ASSERT_EQ(open.size(), 1);
    EXPECT_TRUE(open.front()->findChild<QTextBrowser*>()->toPlainText().startsWith(QStringLiteral("Pose")));
    open.front()->close();
}

TEST(WindowHelp, TheTourPointsAtVisiblePartsAndBlocksNothing)
{
    OpenWindow w;
    w.window.actions()[ui::Command::Tour]->trigger();
    QPointer<ui::Tour> tour = w.window.findChild<ui::Tour*>();
    ASSERT_TRUE(tour);
    EXPECT_GE(tour->stopCount(), 5);
    EXPECT_LE(tour->stopCount(), 7);
    std::set<QString> texts;
    for (int stop = 0; stop < tour->stopCount(); ++stop) {
        tour->goTo(stop);
        EXPECT_TRUE(w.window.rect().contains(tour->geometry())) << stop;
        texts.insert(tour->findChildren<QLabel*>().at(1)->text());
    }
    EXPECT_EQ(static_cast<int>(texts.size()), tour->stopCount());
    w.openSample();   // the window works while the bubble is shown
    EXPECT_TRUE(w.current().vessels.tree);
    QTest::keyClick(tour, Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(tour);
}

TEST(WindowHelp, TheTourOfAnEmptyWindowOpensTheSampleByEnter)
{
    OpenWindow w;
    ASSERT_FALSE(w.current().vessels.tree);
    w.window.actions()[ui::Command::Tour]->trigger();
    QPointer<ui::Tour> tour = w.window.findChild<ui::Tour*>();
    ASSERT_TRUE(tour);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_EQ(tour->current(), 1);
    EXPECT_TRUE(test::waitFor([&] { return w.current().shown().angiogram != nullptr; }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    EXPECT_EQ(tour->current(), 2) << "Enter goes on";
    tour->close();
}

/// Number of amber or orange pixels, which are lines with large residuals.
int missingPixels(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width() - 80; ++x) {   // without the color scale
            const QColor pixel = picture.pixelColor(x, y);
            count += pixel.red() > 170 && pixel.blue() < 110 && pixel.red() > pixel.green() + 30;
        }
    }
    return count;
}

TEST(WindowHelp, BadExamplesMissMoreThanGoodOnes)
{
    int worstGood = 0;
    int bestBad = 1 << 30;
    for (const auto example : {ui::FitExample::Right, ui::FitExample::Deformed, ui::FitExample::Shifted,
                               ui::FitExample::Turned, ui::FitExample::Tilted}) {
        const auto path = fitExampleImage(example);
        ASSERT_TRUE(path) << path.error().message;
        const int missing = missingPixels(QImage(path.value()));
        if (example <= ui::FitExample::Deformed) {
            worstGood = std::max(worstGood, missing);
        } else {
            bestBad = std::min(bestBad, missing);
        }
    }
    EXPECT_GT(bestBad, 2 * worstGood);
}

}   // namespace
}   // namespace angiopose::app
