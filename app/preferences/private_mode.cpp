#include "app/preferences/private_mode.h"

#include "app/preferences/settings.h"

namespace angiopose::app {

bool isPrivate()
{
    return settings::privateMode.read();
}

core::Case caseForExport(const core::Case& session)
{
    core::Case outgoing = session;
    if (isPrivate()) {
        outgoing.title.clear();
    }
    return outgoing;
}

void clearFileDialogHistory()
{
    QSettings dialogs(QSettings::UserScope, QStringLiteral("QtProject"));
    for (const char* key : {"FileDialog/history", "FileDialog/lastVisited"}) {
        dialogs.remove(QLatin1String(key));
    }
}

void clearStoredData()
{
    clearFileDialogHistory();
    for (const Setting<QString>* sensitivity : {&settings::lastFolder, &settings::saveFolder, &settings::observer,
                                                &settings::trialLog, &settings::reportTemplate}) {
        sensitivity->forget();
    }
    settings::recentCases.forget();
    settings::pinnedCases.forget();
    settings::brightness.forget();
}

}   // namespace angiopose::app
