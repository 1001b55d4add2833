#include "app/archive/archive_settings.h"
#include "tests/app/archive_window.h"
#include "ui/archive/port_dialog.h"
#include "ui/archive/receive_line.h"

#include <QCheckBox>

#include <thread>

namespace angiopose::app {
namespace {

using test::OpenWindow;

/// Fixture: the storage SCP of the window. Real peers send to it, to test who may send and how.
class WindowPort : public test::ArchiveWindow {
protected:
    void SetUp() override
    {
        know({});
        dialog = opened();
        ASSERT_TRUE(dialog);
        auto* field = dialog->findChild<QLineEdit*>(QStringLiteral("receivePort"));
        field->selectAll();
        QTest::keyClicks(field, QString::number(port));
        QTest::keyClick(field, Qt::Key_Return);
    }
    void TearDown() override
    {
        settings::receiveCallers.forget();
        settings::receiveHosts.forget();
        settings::receiveTls.forget();
        settings::receiveAuthorities.forget();
        settings::receiveCertificate.forget();
        settings::receiveKey.forget();
        ArchiveWindow::TearDown();
    }

    ui::PortDialog* security() const
    {
        OpenWindow::clickButton(dialog, QStringLiteral("Security…"));
        const auto shown = dialog->findChildren<ui::PortDialog*>();
        EXPECT_EQ(shown.size(), 1);
        return shown.isEmpty() ? nullptr : shown.front();
    }

    static void type(ui::PortDialog& security, const char* field, const std::string& text)
    {
        auto* line = security.findChild<QLineEdit*>(QLatin1String(field));
        ASSERT_TRUE(line);
        line->selectAll();
        QTest::keyClicks(line, QString::fromStdString(text));
    }

    void switchPort() const
    {
        auto* onOff = dialog->findChild<QCheckBox*>(QStringLiteral("receiveSwitch"));
        const bool wasOn = onOff->isChecked();
        QTest::mouseClick(onOff, Qt::LeftButton, {}, {8, onOff->height() / 2});
        const auto* field = dialog->findChild<QLineEdit*>(QStringLiteral("receivePort"));
        EXPECT_TRUE(test::waitFor([&] { return field->isEnabled() == wasOn; }));
        QTest::qWait(300);   // until the receiver listens
    }

    io::ArchiveNode us(const std::string& caller) const
    {
        io::ArchiveNode node = nodeAt(port);
        node.title = "ANGIOPOSE";
        node.ownAeTitle = caller;
        node.responseTimeoutSeconds = 5;
        return node;
    }

    io::TransferReport sendTo(const io::ArchiveNode& node, const std::string& series) const
    {
        io::TransferReport report;
        const auto files = test::writeObjects(folder, series, 2);
        std::atomic<bool> isOver{false};
        std::thread peer([&] {
            report = io::sendToArchive(node, io::ArchiveProtocol::Dimse, files);
            isOver = true;
        });
        EXPECT_TRUE(test::waitFor([&] { return isOver.load(); }));
        peer.join();
        return report;
    }

    bool says(const char* statusText) const
    {
        const auto* said = dialog->findChild<QLabel*>(QStringLiteral("receiveWords"));
        const auto isSaid = [&] { return said->text().contains(QLatin1String(statusText)); };
        const bool found = test::waitFor(isSaid);
        EXPECT_TRUE(found) << said->text().toStdString();
        return found;
    }

    ui::ArchiveDialog* dialog = nullptr;
    int port = test::freePort();
};

TEST_F(WindowPort, OnlyListedCallersAreTakenAndStrangersAreReported)
{
    ui::PortDialog* asked = security();
    ASSERT_TRUE(asked);
    type(*asked, "portTitles", "A TITLE OF MORE THAN 16");
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    EXPECT_TRUE(asked->isVisible());
    EXPECT_TRUE(asked->line().statusText().contains(QStringLiteral("valid AE")))
        << asked->line().statusText().toStdString();
    type(*asked, "portTitles", "MODALITY, CT 7");
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    EXPECT_FALSE(asked->isVisible());
    const test::AuditFile audit(folder);
    switchPort();
    EXPECT_FALSE(dialog->findChild<QPushButton*>(QStringLiteral("receiveSecurity"))->isEnabled()) << "it listens";
    EXPECT_FALSE(sendTo(us("STRANGER"), "2.25.4711.81").isComplete());
    says("(AE title STRANGER) was rejected");
    EXPECT_TRUE(sendTo(us("CT 7"), "2.25.4711.82").isComplete());
    says("Objects received: 2");
    switchPort();
    EXPECT_TRUE(test::waitFor([&] { return audit.text().count(QStringLiteral("sha256")) == 2; }))
        << audit.text().toStdString();
    EXPECT_TRUE(audit.text().contains(QStringLiteral("\"received\"")));

    dialog->reject();
    QTest::qWait(0);
    dialog = opened();
    ASSERT_TRUE(dialog);
    asked = security();
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->entry().titles, QStringLiteral("MODALITY, CT 7")) << "it is remembered";
}

TEST_F(WindowPort, StrangeAddressesAreTurnedAway)
{
    ui::PortDialog* asked = security();
    ASSERT_TRUE(asked);
    type(*asked, "portHosts", "10.1.2.3");
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    switchPort();
    EXPECT_FALSE(sendTo(us("MODALITY"), "2.25.4711.83").isComplete());
    says("127.0.0.1 (AE title MODALITY) was rejected");
    switchPort();
}

TEST_F(WindowPort, TlsTakesKnownCertificatesOnly)
{
    const auto ours = test::makeCertificate(folder, "ours");
    const auto theirs = test::makeCertificate(folder, "theirs");
    const auto stranger = test::makeCertificate(folder, "stranger");
    if (!ours || !theirs || !stranger) {
        GTEST_SKIP() << "openssl is not installed";
    }
    ui::PortDialog* asked = security();
    ASSERT_TRUE(asked);
    auto* tls = asked->findChild<QCheckBox*>(QStringLiteral("portTls"));
    QTest::mouseClick(tls, Qt::LeftButton, {}, {8, tls->height() / 2});
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    EXPECT_TRUE(asked->line().statusText().contains(QStringLiteral("requires a local certificate")))
        << "there is none yet";
    type(*asked, "portCertificate", ours->certificateFile);
    type(*asked, "portKey", ours->keyFile);
    type(*asked, "portTrusted", theirs->certificateFile);
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    EXPECT_FALSE(asked->isVisible());
    switchPort();

    io::ArchiveNode node = us("MODALITY");
    EXPECT_FALSE(sendTo(node, "2.25.4711.84").isComplete()) << "in the clear";
    says("the TLS handshake failed");
    node.isTls = true;
    node.caFile = ours->certificateFile;
    node.certificateFile = theirs->certificateFile;
    node.keyFile = theirs->keyFile;
    const io::TransferReport report = sendTo(node, "2.25.4711.85");
    EXPECT_TRUE(report.isComplete()) << (report.end ? report.end->message.text() : std::string());
    says("Objects received: 2");
    node.certificateFile = stranger->certificateFile;
    node.keyFile = stranger->keyFile;
    EXPECT_FALSE(sendTo(node, "2.25.4711.86").isComplete());
    switchPort();
}

TEST_F(WindowPort, UselessCertificateIsNamed)
{
    folder.write("no.pem", "nothing");
    ui::PortDialog* asked = security();
    ASSERT_TRUE(asked);
    auto* tls = asked->findChild<QCheckBox*>(QStringLiteral("portTls"));
    QTest::mouseClick(tls, Qt::LeftButton, {}, {8, tls->height() / 2});
    type(*asked, "portCertificate", folder.file("no.pem"));
    type(*asked, "portKey", folder.file("no.pem"));
    OpenWindow::clickButton(asked, QStringLiteral("Save"));
    auto* onOff = dialog->findChild<QCheckBox*>(QStringLiteral("receiveSwitch"));
    QTest::mouseClick(onOff, Qt::LeftButton, {}, {8, onOff->height() / 2});
    const auto isKnown = [&] { return dialog->line().statusText().contains(QStringLiteral("no.pem")); };
    EXPECT_TRUE(test::waitFor(isKnown)) << dialog->line().statusText().toStdString();
    EXPECT_FALSE(onOff->isChecked());
}

}   // namespace
}   // namespace angiopose::app
