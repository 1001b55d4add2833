#include "app/preferences/settings.h"
#include "tests/app/open_window.h"
#include "tests/io/study/study_disc.h"
#include "tests/support/forked_vessel.h"
#include "ui/dialogs/study_browser.h"
#include "ui/dialogs/study_list.h"

#include <QLabel>
#include <QTreeWidgetItemIterator>

#include <filesystem>

namespace angiopose::app {
namespace {

using test::OpenWindow;

ui::StudyBrowser* browserOf(OpenWindow& w)
{
    ui::StudyBrowser* browser = nullptr;
    EXPECT_TRUE(test::waitFor([&] {
        const auto shown = w.dialogs("studyBrowser");
        browser = shown.isEmpty() ? nullptr : qobject_cast<ui::StudyBrowser*>(shown.front());
        return browser != nullptr;
    }));
    if (browser) {
        browser->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(browser, test::patienceMs));
    }
    return browser;
}

/// The visible item whose first column begins with `words`.
QTreeWidgetItem* itemOf(ui::StudyList& list, const QString& words)
{
    for (QTreeWidgetItemIterator at(&list, QTreeWidgetItemIterator::NotHidden); *at; ++at) {
        if ((*at)->text(0).startsWith(words)) {
            return *at;
        }
    }
    return nullptr;
}

void clickTick(ui::StudyList& list, QTreeWidgetItem* item)
{
    list.scrollToItem(item);
    const QRect row = list.visualItemRect(item);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, {row.left() + 10, row.center().y()});
}

bool isOpened(OpenWindow& w)
{
    return test::waitFor([&] { return !w.controller.isLoading() && w.current().shown().angiogram; });
}

TEST(WindowStudy, ADiscIsListedWithPicturesAndReasons)
{
    const test::TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    OpenWindow w;

    w.drop({QString::fromStdString(folder.file("DICOMDIR"))});

    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    ui::StudyList& list = browser->list();
    ASSERT_EQ(list.topLevelItemCount(), 1);
    EXPECT_TRUE(list.topLevelItem(0)->text(0).startsWith(QStringLiteral("Phantom CT")));
    EXPECT_EQ(list.seriesCount(), 3);
    QTreeWidgetItem* scan = itemOf(list, QStringLiteral("CTA 0.75"));
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->text(2), QStringLiteral("CT"));
    EXPECT_EQ(scan->text(3), QStringLiteral("10"));
    EXPECT_TRUE(scan->flags() & Qt::ItemIsUserCheckable);
    const auto isDrawn = [](QTreeWidgetItem* item) {
        const QImage tile = item->icon(0).pixmap(56, 56).toImage();
        QSet<QRgb> tones;
        for (int x = 0; x < tile.width(); ++x) {
            for (int y = 0; y < tile.height(); ++y) {
                tones.insert(tile.pixel(x, y));
            }
        }
        return tones.size() > 3;
    };
    EXPECT_TRUE(test::waitFor([&] { return isDrawn(itemOf(list, QStringLiteral("CTA 0.75"))); })) << "its middle slice";
    QTreeWidgetItem* report = nullptr;
    for (QTreeWidgetItemIterator at(&list); *at; ++at) {
        report = (*at)->text(2) == QStringLiteral("SR") ? *at : report;
    }
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->flags() & Qt::ItemIsUserCheckable);
    EXPECT_TRUE(report->toolTip(0).contains(QStringLiteral("report")));
}

TEST(WindowStudy, TheNoticeOfTheFirstStartIsAnsweredFirst)
{
    const test::TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    const bool wasAccepted = settings::noticeAccepted.read();
    const bool wasToured = settings::isTourCompleted.read();
    settings::noticeAccepted.write(false);
    settings::isTourCompleted.write(false);
    OpenWindow w;
    w.controller.begin({QString::fromStdString(folder.file("DICOMDIR"))});
    ASSERT_EQ(w.dialogs("noticeDialog").size(), 1);
    QTest::qWait(1000);   // the disc is listed long since
    EXPECT_TRUE(w.dialogs("studyBrowser").isEmpty()) << "it would lie over the notice";
    QTest::keyClick(w.dialogs("noticeDialog").front(), Qt::Key_Return);
    EXPECT_TRUE(browserOf(w));
    EXPECT_FALSE(w.window.findChild<QWidget*>(QStringLiteral("tour"))) << "whose first word is the sample case";
    settings::noticeAccepted.write(wasAccepted);
    settings::isTourCompleted.write(wasToured);
}

TEST(WindowStudy, TheKeyboardAloneOpensACase)
{
    const test::TemporaryFolder folder;
    test::writeShuffled(folder, test::allSlices(test::forkScan()));
    ASSERT_TRUE(io::writeAngiogram(test::spotRun(), folder.file("run.dcm")));
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    ui::StudyList& list = browser->list();
    EXPECT_TRUE(test::waitFor([&list] { return list.hasFocus(); }));

    list.setCurrentItem(itemOf(list, QStringLiteral("CTA 0.75")));
    QTest::keyClick(&list, Qt::Key_Space);
    EXPECT_FALSE(list.chosenVessels().isEmpty());
    for (QTreeWidgetItemIterator at(&list); *at; ++at) {
        if ((*at)->text(2) == QStringLiteral("XA")) {
            list.setCurrentItem(*at);
        }
    }
    QTest::keyClick(&list, Qt::Key_Return);

    ASSERT_TRUE(isOpened(w));
    EXPECT_TRUE(w.current().vessels.tree);
    EXPECT_EQ(w.current().vessels.input.seriesId, "1.2.3");
    EXPECT_EQ(w.current().views.size(), 1u);
    w.press(Qt::Key_Z, Qt::ControlModifier);
}

TEST(WindowStudy, FurtherRunsBecomeViews)
{
    const test::TemporaryFolder folder;
    test::writeShuffled(folder, test::allSlices(test::forkScan()));
    core::Angiogram other = test::spotRun();
    other.frames.resize(2);
    ASSERT_TRUE(io::writeAngiogram(test::spotRun(), folder.file("one.dcm")));
    ASSERT_TRUE(io::writeAngiogram(other, folder.file("two.dcm")));
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    for (QTreeWidgetItemIterator at(&browser->list(), QTreeWidgetItemIterator::NoChildren); *at; ++at) {
        clickTick(browser->list(), *at);
    }
    EXPECT_EQ(browser->list().chosenViews().size(), 2);

    OpenWindow::clickButton(browser, QStringLiteral("Open"));

    EXPECT_TRUE(test::waitFor([&] { return w.current().views.size() == 2 && !w.controller.isLoading(); }));
    EXPECT_TRUE(w.current().vessels.tree);
}

TEST(WindowStudy, OnlyOneScanGivesTheVessels)
{
    const test::TemporaryFolder folder;
    test::writeDisc(folder);
    for (test::CtSlice slice : test::allSlices(test::ctPhantom())) {
        slice.seriesUid = "1.2.44";
        slice.description = "second";
        slice.sopInstanceUid += ".44";
        folder.write("second/" + std::to_string(slice.instanceNumber), test::ctSlice(slice));
    }
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);

    clickTick(browser->list(), itemOf(browser->list(), QStringLiteral("CTA 0.75")));
    const QString first = browser->list().chosenVessels();
    clickTick(browser->list(), itemOf(browser->list(), QStringLiteral("second")));

    EXPECT_FALSE(first.isEmpty());
    EXPECT_NE(browser->list().chosenVessels(), first);
    EXPECT_EQ(itemOf(browser->list(), QStringLiteral("CTA 0.75"))->checkState(0), Qt::Unchecked);
    browser->reject();
    EXPECT_FALSE(w.current().vessels.tree);
}

TEST(WindowStudy, ADoubleClickTakesARunAsAView)
{
    const test::TemporaryFolder folder;
    test::writeDisc(folder);
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    QTreeWidgetItem* run = nullptr;
    for (QTreeWidgetItemIterator at(&browser->list()); *at; ++at) {
        run = (*at)->text(2) == QStringLiteral("XA") ? *at : run;
    }
    ASSERT_TRUE(run);
    browser->list().scrollToItem(run);
    const QPoint place = browser->list().visualItemRect(run).center();
    QTest::mouseClick(browser->list().viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(browser->list().viewport(), Qt::LeftButton, {}, place);

    ASSERT_TRUE(isOpened(w));
    EXPECT_FALSE(w.current().vessels.tree);
    EXPECT_EQ(w.current().shown().angiogram->frameCount(), 3);
}

TEST(WindowStudy, AFolderWithOneThingOpensWithoutAList)
{
    const test::TemporaryFolder folder;
    ASSERT_TRUE(io::writeAngiogram(test::spotRun(), folder.file("run.dcm")));
    OpenWindow w;

    w.drop({QString::fromStdString(folder.file(""))});

    ASSERT_TRUE(isOpened(w));
    EXPECT_TRUE(w.dialogs("studyBrowser").isEmpty());
}

TEST(WindowStudy, SearchAndHiddenIdentity)
{
    const test::TemporaryFolder folder;
    test::writeDisc(folder);
    test::CtSlice other = test::sliceOf(test::ctPhantom(), 0);
    other.patientName = "Roe^Richard";
    other.patientId = "4711";
    other.seriesUid = "1.2.66";
    folder.write("roe", test::ctSlice(other));
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    ui::StudyList& list = browser->list();

    QTest::keyClick(browser, Qt::Key_F, Qt::ControlModifier);
    auto* search = browser->findChild<QLineEdit*>();
    ASSERT_TRUE(test::waitFor([search] { return search->hasFocus(); }));
    QTest::keyClicks(search, QStringLiteral("4711"));
    EXPECT_TRUE(itemOf(list, QStringLiteral("Roe Richard")));
    EXPECT_FALSE(itemOf(list, QStringLiteral("Phantom CT")));
    search->clear();
    list.setFocus();

    QTest::keyClick(&list, Qt::Key_P, Qt::ShiftModifier);

    EXPECT_FALSE(itemOf(list, QStringLiteral("Roe Richard")));
    EXPECT_TRUE(itemOf(list, QStringLiteral("Patient 2")));
    QTest::keyClick(&list, Qt::Key_P, Qt::ShiftModifier);
    EXPECT_TRUE(itemOf(list, QStringLiteral("Roe Richard")));
}

TEST(WindowStudy, WhatLiesBesideADicomdirIsOfferedAndDamagedFilesAreNamed)
{
    const test::TemporaryFolder folder;
    test::writeDicomdir(folder.file(""), test::writeDisc(folder));
    test::CtSlice other = test::sliceOf(test::ctPhantom(), 0);
    other.seriesUid = "1.2.55";
    for (int i = 0; i < 5; ++i) {
        other.sopInstanceUid = "1.2.55." + std::to_string(i);
        other.position[2] += 1.0;
        folder.write("MORE" + std::to_string(i), test::ctSlice(other));
    }
    std::filesystem::resize_file(folder.file("CT/IM4"), std::filesystem::file_size(folder.file("CT/IM4")) - 20);
    OpenWindow w;
    w.drop({QString::fromStdString(folder.file(""))});
    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    const auto says = [browser](const QString& words) {
        for (const QLabel* label : browser->findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(says(QStringLiteral("3 series")));
    EXPECT_TRUE(says(QStringLiteral("5 more files")));

    OpenWindow::clickButton(browser, QStringLiteral("Also read them"));

    EXPECT_TRUE(test::waitFor([&] { return browser->list().seriesCount() == 4; }));
    EXPECT_TRUE(test::waitFor([&] { return !w.controller.isLoading(); }));
    OpenWindow::clickButton(browser, QStringLiteral("Damaged files: 1"));
    const auto* damaged = browser->findChild<QPlainTextEdit*>();
    EXPECT_TRUE(damaged->isVisible());
    EXPECT_TRUE(damaged->toPlainText().contains(QStringLiteral("IM4")));
}

TEST(WindowStudy, ThousandsOfFilesLeaveTheWindowFreeAndStopKeepsWhatWasFound)
{
    const test::TemporaryFolder folder;
    test::CtSlice slice = test::sliceOf(test::ctPhantom(), 0);
    for (int i = 0; i < 3000; ++i) {
        slice.seriesUid = "1.2.9." + std::to_string(i % 30);
        slice.sopInstanceUid = slice.seriesUid + "." + std::to_string(i);
        slice.position[2] = i;
        folder.write(std::to_string(i), test::ctSlice(slice));
    }
    OpenWindow w;
    QElapsedTimer clock;
    qint64 longestMs = 0;
    QTimer beat;
    QObject::connect(&beat, &QTimer::timeout, [&] { longestMs = std::max(longestMs, clock.restart()); });
    clock.start();
    beat.start(1);
    w.controller.open({QString::fromStdString(folder.file(""))});

    ui::StudyBrowser* browser = browserOf(w);
    ASSERT_TRUE(browser);
    for (QPushButton* button : browser->findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Stop") && button->isVisible()) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    EXPECT_TRUE(test::waitFor([&] { return !w.controller.isLoading(); }));

    EXPECT_GT(browser->list().seriesCount(), 0);
    EXPECT_LT(longestMs, 1500) << "showing the window itself takes a while under a software renderer";
    browser->reject();
}

}   // namespace
}   // namespace angiopose::app
