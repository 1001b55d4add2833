#include "app/files/recent_cases.h"

#include "app/files/case_pictures.h"
#include "app/preferences/settings.h"

#include <QFileInfo>

namespace angiopose::app {
namespace {

constexpr qsizetype keptCases = 10;

}   // namespace

QStringList recentCases()
{
    return settings::recentCases.read();
}

void rememberCase(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    const QStringList before = recentCases();
    QStringList cases = before;
    cases.removeAll(absolute);
    cases.prepend(absolute);
    cases = cases.first(std::min(cases.size(), keptCases));
    if (cases != before) {
        settings::recentCases.write(cases);
        keepCasePictures(cases);
    }
}

void forgetRecentCases()
{
    settings::recentCases.write({});
    keepCasePictures({});
}

}   // namespace angiopose::app