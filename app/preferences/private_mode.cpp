#include "app/preferences/private_mode.h"

#include "app/preferences/settings.h"

namespace angiopose::app {

bool isPrivate()
{
    return settings::privateMode.read();
}

core::Case outgoingCase(const core::Case& session)
{
    core::Case outgoing = session;
    if (isPrivate()) {
        outgoing.title.clear();
    }
    return outgoing;
}

void forgetFileDialogs()
{
    QSettings dialogs(QSettings::UserScope, QStringLiteral("QtProject"));
    for (const char* key : {"FileDialog/history", "FileDialog/lastVisited"}) {
        dialogs.remove(QLatin1String(key));
    }
}

void forgetTraces()
{
    forgetFileDialogs();
    for (const Setting<QString>* informative : {&settings::lastFolder, &settings::saveFolder, &settings::observer,
                                                &settings::trialLog, &settings::reportTemplate}) {
        informative->forget();
    }
    settings::recentCases.forget();
    settings::pinnedCases.forget();
    settings::brightness.forget();
}

}   // namespace angiopose::app
