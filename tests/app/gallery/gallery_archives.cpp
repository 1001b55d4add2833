#include "tests/app/gallery/gallery.h"

#include "ui/archive/archive_dialog.h"
#include "ui/archive/match_list.h"
#include "ui/archive/node_dialog.h"
#include "ui/archive/receive_line.h"
#include "ui/archive/send_dialog.h"
#include "ui/archive/transfer_line.h"
#include "ui/main_window.h"

#include <QTest>

namespace angiopose::test {
namespace {

const QString nodeName = QStringLiteral("Radiology PACS");

std::vector<ui::MatchRow> studies()
{
    const auto study = [](const char* key, const char* patient, const char* id, const char* date, const char* modality,
                          const char* description, int images) {
        return ui::MatchRow{QString::fromLatin1(key),
                            QString::fromUtf8(patient),
                            QString::fromLatin1(id),
                            QString::fromLatin1(date),
                            QString::fromLatin1(modality),
                            QString::fromLatin1(description),
                            images};
    };
    return {study("a", "Müller Änne", "P-4711", "2026-03-05", "CT", "Coronary CTA", 612),
            study("b", "Müller Änne", "P-4711", "2026-03-06", "XA, SR", "Coronary angiography, both arteries", 58),
            study("c", "O'Brien Mary Margaret Louise", "IE-1", "2025-11-30", "CT", "", 301)};
}

}   // namespace

void Gallery::showArchives(ui::MainWindow& window)
{
    auto* dialog = new ui::ArchiveDialog(&window);
    dialog->receive().showPort(11112, QStringLiteral("ANGIOPOSE"));
    dialog->cache().showCache(QStringLiteral("13 MB"), false, 20.0, {});
    dialog->open();
    QTest::qWait(100);
    take(*dialog, QStringLiteral("archive_none_yet"));
    dialog->nodes().showNodes({nodeName}, nodeName);
    dialog->list().showStudies(studies());
    dialog->receive().showListening(true);
    dialog->receive().showReceived(QStringLiteral("–"), true);
    dialog->line().showProgress(QStringLiteral("12 / 58"), 12, 58);
    QTest::qWait(100);
    take(*dialog, QStringLiteral("archive_under_way"));
    dialog->line().showProblem(QStringLiteral("–"));
    dialog->offerPartialSeries(true);
    takeDialogs(window, QStringLiteral("archive"));

    for (const bool isTls : {false, true}) {
        ui::ArchiveEntry entry;
        entry.isTls = isTls;   // shows the further fields
        (new ui::NodeDialog(entry, ui::NodeDialog::Purpose::Add, &window))->open();
        QTest::qWait(100);
        takeDialogs(window, isTls ? QStringLiteral("archive_node_further") : QStringLiteral("archive_node"));
    }

    auto* sending = new ui::SendDialog(&window);
    sending->nodes().showNodes({nodeName}, nodeName);
    sending->showNode();
    sending->open();
    QTest::qWait(100);
    takeDialogs(window, QStringLiteral("archive_send"));
}

}   // namespace angiopose::test
