#include "tests/app/session/session_check.h"
#include "tests/app/wait_for.h"

#include <QDir>
#include <QFile>
#include <QTest>

namespace angiopose::test {
namespace {

bool save(app::CaseController& controller, const QString& path)
{
    bool isSaved = false;
    controller.saveController().saveTo(path, [&isSaved] { isSaved = true; });
    return test::waitFor([&isSaved] { return isSaved; });
}

QByteArrayList linesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().split('\n') : QByteArrayList{};
}

}   // namespace

QString differenceAfterReopening(app::CaseController& controller, const QString& folder)
{
    // The same file name, because associated files are named after the case.
    const QString first = folder + QStringLiteral("/first/case.angiopose");
    const QString second = folder + QStringLiteral("/second/case.angiopose");
    if (!QDir(folder).mkpath(QStringLiteral("first")) || !QDir(folder).mkpath(QStringLiteral("second"))) {
        return QStringLiteral("could not make folders");
    }
    if (!save(controller, first)) {
        return QStringLiteral("could not save");
    }
    ui::MainWindow window;
    app::CaseController reopened(window);
    window.show();
    reopened.open({first});
    if (!test::waitFor([&reopened] { return !reopened.isLoading() && !reopened.document().isEmpty(); })) {
        return QStringLiteral("could not reopen");
    }
    if (!save(reopened, second)) {
        return QStringLiteral("could not save again");
    }
    const QByteArrayList before = linesOf(first);
    const QByteArrayList after = linesOf(second);
    for (qsizetype i = 0; i < std::max(before.size(), after.size()); ++i) {
        if (before.value(i) != after.value(i)) {
            return QStringLiteral("line %1: “%2” became “%3”")
                .arg(i + 1)
                .arg(QString::fromUtf8(before.value(i)), QString::fromUtf8(after.value(i)));
        }
    }
    return {};
}

}   // namespace angiopose::test
