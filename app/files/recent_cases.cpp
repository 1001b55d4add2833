#include "app/files/recent_cases.h"

#include "app/files/case_pictures.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/settings.h"

#include <QFileInfo>

#include <algorithm>

namespace angiopose::app {
namespace {

constexpr qsizetype keptCases = 30;   // beside the pinned ones

void store(const QStringList& cases)
{
    if (cases != settings::recentCases.read()) {
        settings::recentCases.write(cases);
        keepCasePictures(cases);
    }
}

}   // namespace

QStringList recentCases()
{
    QStringList cases = settings::recentCases.read();
    const QStringList pinned = settings::pinnedCases.read();
    std::stable_partition(cases.begin(), cases.end(), [&pinned](const QString& path) { return pinned.contains(path); });
    return cases;
}

void rememberCase(const QString& path)
{
    if (isPrivate()) {
        return;
    }
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QStringList pinned = settings::pinnedCases.read();
    QStringList cases = settings::recentCases.read();
    cases.removeAll(absolute);
    cases.prepend(absolute);
    for (qsizetype i = cases.size(), left = cases.size() - keptCases - pinned.size(); i-- > 0 && left > 0;) {
        if (!pinned.contains(cases[i])) {
            cases.removeAt(i);
            --left;
        }
    }
    store(cases);
}

void forgetCase(const QString& path)
{
    setPinned(path, false);
    QStringList cases = settings::recentCases.read();
    cases.removeAll(path);
    store(cases);
}

void forgetRecentCases()
{
    const QStringList pinned = settings::pinnedCases.read();
    QStringList cases = settings::recentCases.read();
    cases.removeIf([&pinned](const QString& path) { return !pinned.contains(path); });
    settings::recentCases.write(cases);
    keepCasePictures(cases);
}

bool isPinned(const QString& path)
{
    return settings::pinnedCases.read().contains(path);
}

void setPinned(const QString& path, bool pinned)
{
    QStringList paths = settings::pinnedCases.read();
    paths.removeAll(path);
    if (pinned) {
        paths << path;
    }
    settings::pinnedCases.write(paths);
}

}   // namespace angiopose::app
