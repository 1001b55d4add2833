#include "tests/app/archive_window.h"
#include "ui/archive/send_dialog.h"

#include <QCheckBox>

#include <thread>

namespace angiopose::app {
namespace {

using test::OpenWindow;

class WindowSending : public test::ArchiveWindow {
protected:
    ui::SendDialog* asked()
    {
        w.openSample();
        w.window.actions()[ui::Command::SendToArchive]->trigger();
        const auto dialogs = w.dialogs("dicomDialog");
        EXPECT_EQ(dialogs.size(), 1);
        dialogs.front()->findChildren<QCheckBox*>()[1]->setChecked(false);   // overlay images of a run take long
        OpenWindow::clickButton(dialogs.front(), QStringLiteral("Choose PACS…"));
        ui::SendDialog* dialog = nullptr;
        const auto isThere = [&] {
            const auto shown = w.dialogs("archiveSendDialog");
            dialog = shown.isEmpty() ? nullptr : qobject_cast<ui::SendDialog*>(shown.front());
            return dialog && !dialog->nodes().node().isEmpty();
        };
        EXPECT_TRUE(test::waitFor(isThere));
        return dialog;
    }
};

TEST_F(WindowSending, WhatIsPushedIsCountedAndOffered)
{
    know({});
    ui::ArchiveDialog* dialog = opened();
    ASSERT_TRUE(dialog);
    const int port = test::freePort();
    auto* field = dialog->findChild<QLineEdit*>(QStringLiteral("receivePort"));
    field->selectAll();
    QTest::keyClicks(field, QString::number(port));
    QTest::keyClick(field, Qt::Key_Return);
    auto* onOff = dialog->findChild<QCheckBox*>(QStringLiteral("receiveSwitch"));
    QTest::mouseClick(onOff, Qt::LeftButton, {}, {8, onOff->height() / 2});
    EXPECT_TRUE(onOff->isChecked());
    EXPECT_TRUE(test::waitFor([&] { return !field->isEnabled(); }));
    QTest::qWait(200);   // until the receiver listens
    io::ArchiveNode us = nodeAt(port);
    us.title = "ANGIOPOSE";
    io::TransferReport report;
    std::thread peer([&] {
        report = io::sendToArchive(us, io::ArchiveProtocol::Dimse, test::writeObjects(folder, "2.25.4711.71", 3));
    });
    const auto* said = dialog->findChild<QLabel*>(QStringLiteral("receiveWords"));
    EXPECT_TRUE(test::waitFor([&] { return said->text() == QStringLiteral("Objects received: 3"); }));
    peer.join();
    EXPECT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : std::string())
                                     << dialog->line().statusText().toStdString();
    QTest::mouseClick(onOff, Qt::LeftButton, {}, {8, onOff->height() / 2});
    EXPECT_TRUE(test::waitFor([&] { return field->isEnabled(); })) << "it is off";
}

TEST_F(WindowSending, ObjectsArriveAndAfterAFaultTheSameOnesGoAgain)
{
    NEEDS_ORTHANC();
    test::CuttingProxy line(orthanc_->dicomPort(), 500);
    know({nodeAt(line.port())});
    ui::SendDialog* dialog = asked();
    ASSERT_TRUE(dialog);
    EXPECT_TRUE(dialog->line().statusText().contains(QStringLiteral("sent to pacs")));
    const test::Heartbeat beat;
    OpenWindow::clickButton(dialog, QStringLiteral("Send"));
    const QString fault = statusText(dialog->line());
    EXPECT_TRUE(fault.contains(QStringLiteral("objects were delivered."))) << fault.toStdString();
    line.heal();
    OpenWindow::clickButton(dialog, QStringLiteral("Send"));
    const QString said = statusText(dialog->line());
    EXPECT_TRUE(said.startsWith(QStringLiteral("pacs received all objects: 4"))) << said.toStdString();
    RecordProperty("longestGapMs", static_cast<int>(beat.longestMs()));
    OpenWindow::clickButton(dialog, QStringLiteral("Close"));
}

TEST_F(WindowSending, NothingIsSentWithoutACase)
{
    know({nodeAt(test::freePort())});
    w.window.actions()[ui::Command::SendToArchive]->trigger();
    EXPECT_TRUE(w.dialogs("dicomDialog").isEmpty());
}

}   // namespace
}   // namespace angiopose::app
