#pragma once

#include "app/preferences/settings.h"
#include "io/archive/node_file.h"
#include "tests/app/open_window.h"
#include "tests/io/archive/archive_objects.h"
#include "tests/io/archive/faulty_peers.h"
#include "tests/io/archive/orthanc.h"
#include "ui/archive/archive_dialog.h"
#include "ui/archive/match_list.h"
#include "ui/archive/search_fields.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"

#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QTimer>

#include <algorithm>
#include <filesystem>

namespace angiopose::test {

/// Measures the longest time for which the window's event loop was blocked.
class Heartbeat {
public:
    Heartbeat()
    {
        QObject::connect(&beat_, &QTimer::timeout, &beat_,
                         [this] { longestMs_ = std::max(longestMs_, clock_.restart()); });
        clock_.start();
        beat_.start(1);
    }
    qint64 longestMs() const { return longestMs_; }

private:
    QElapsedTimer clock_;
    qint64 longestMs_ = 0;
    QTimer beat_;
};

class AuditFile {
public:
    explicit AuditFile(const TemporaryFolder& folder) : path_(QString::fromStdString(folder.file("audit.jsonl")))
    {
        app::settings::auditFile.write(path_);
    }
    ~AuditFile() { app::settings::auditFile.write({}); }
    AuditFile(const AuditFile&) = delete;
    AuditFile& operator=(const AuditFile&) = delete;

    QString text() const
    {
        QFile file(path_);
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }

private:
    QString path_;
};

/// Fixture that uses archives through the window, by mouse and keyboard, against a real server where one is installed.
class ArchiveWindow : public ::testing::Test {
protected:
    static void SetUpTestSuite() { orthanc_ = std::make_unique<Orthanc>(); }
    static void TearDownTestSuite() { orthanc_.reset(); }
    void TearDown() override { std::filesystem::remove(io::defaultArchiveSettingsFile()); }

    static io::ArchiveNode nodeAt(int port)
    {
        io::ArchiveNode node;
        node.name = "pacs";
        node.host = "127.0.0.1";
        node.port = port;
        node.title = Orthanc::title;
        return node;
    }

    void know(const std::vector<io::ArchiveNode>& nodes) const
    {
        io::ArchiveSettings settings;
        settings.nodes = nodes;
        settings.cacheFolder = folder.file("cache");
        ASSERT_TRUE(io::writeArchiveSettings(settings, io::defaultArchiveSettingsFile()));
    }

    ui::ArchiveDialog* opened()
    {
        w.window.actions()[ui::Command::QueryPacs]->trigger();
        const auto shown = w.dialogs("archiveDialog");
        auto* dialog = shown.isEmpty() ? nullptr : qobject_cast<ui::ArchiveDialog*>(shown.front());
        const QLabel* size = dialog ? dialog->findChild<QLabel*>(QStringLiteral("cacheSize")) : nullptr;
        EXPECT_TRUE(size && test::waitFor([size] { return !size->text().isEmpty(); }));
        return dialog;
    }

    /// Waits until no transfer is running and returns the text that is shown then.
    static QString statusText(ui::TransferLine& line)
    {
        EXPECT_TRUE(test::waitFor([&line] { return !line.isBusy(); })) << "still busy";
        return line.statusText();
    }

    static void search(ui::ArchiveDialog& dialog, const QString& name)
    {
        auto* field = dialog.fields().findChild<QLineEdit*>();
        field->setFocus();
        field->clear();
        QTest::keyClicks(field, name);
        QTest::keyClick(field, Qt::Key_Return);
        statusText(dialog.line());
    }

    /// Stores two runs of one study, of `frames` frames each, in the archive.
    void store(int frames, int side = 64) const
    {
        std::vector<std::string> files;
        for (const std::string series : {"2.25.4711.61", "2.25.4711.62"}) {
            files.push_back(folder.write(series + ".dcm", objectText(0, series, side, frames)));
        }
        const auto report = io::sendToArchive(nodeAt(orthanc_->dicomPort()), io::ArchiveProtocol::Dimse, files);
        ASSERT_TRUE(report.isComplete());
    }

    OpenWindow w;
    TemporaryFolder folder;
    static inline std::unique_ptr<Orthanc> orthanc_;
};

#define NEEDS_ORTHANC()                     \
    if (!orthanc_->isRunning()) {           \
        GTEST_SKIP() << orthanc_->whyNot(); \
    }                                       \
    static_assert(true)

}   // namespace angiopose::test
