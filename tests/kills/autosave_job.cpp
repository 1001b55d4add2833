#include "tests/kills/autosave_job.h"

#include "app/document/case_document.h"
#include "app/files/autosave.h"
#include "tests/kills/kept_case.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>
#include <QUndoCommand>

#include <unistd.h>

namespace angiopose::test {

std::string autosaveFolderOf(const std::string& folder)
{
    return folder + "/data/AngioPose/AngioPose/autosave";
}

int autosaveForEver(const std::string& folder, int ready)
{
    qputenv("XDG_DATA_HOME", QByteArray::fromStdString(folder + "/data"));
    int count = 1;
    char name[] = "kill_table";
    char* values[] = {name, nullptr};
    const QCoreApplication application(count, values);
    QCoreApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QCoreApplication::setApplicationName(QStringLiteral("AngioPose"));
    auto session = wholeCase(folder + "/case.angiopose");
    if (!session) {
        return 1;
    }
    session->title = titleOf(7);
    app::CaseDocument document;
    document.replace(*session, QString::fromStdString(folder + "/case.angiopose"));
    app::Autosave autosave(document);
    QEventLoop loop;
    QObject::connect(&autosave, &app::Autosave::saved, &loop, &QEventLoop::quit);
    QObject::connect(&autosave, &app::Autosave::failed, &loop, [&loop] { loop.exit(1); });
    (void)!::write(ready, "r", 1);
    while (true) {
        document.undoStack().push(new QUndoCommand);
        QTimer again;   // the queue may still be processing the previous save
        QObject::connect(&again, &QTimer::timeout, &autosave, &app::Autosave::saveSoon);
        again.start(1);
        if (loop.exec() != 0) {
            return 1;
        }
    }
}

}   // namespace angiopose::test
