#include "app/words/snapshot_texts.h"

#include "app/preferences/private_mode.h"
#include "core/support/utc_time.h"
#include "ui/words/number.h"
#include "ui/words/terms.h"

namespace angiopose::app {

QString observerName()
{
    return isPrivate() ? QString() : qEnvironmentVariable("USER");
}

core::PoseSnapshot snapshotOfRun(const core::RegistrationResult& result, int frame)
{
    core::PoseSnapshot snapshot;
    snapshot.kind = core::SnapshotKind::Run;
    snapshot.time = core::utcNow();
    snapshot.method = result.method;
    snapshot.author = observerName().toStdString();
    snapshot.name = (ui::methodName(result.method) + QLatin1Char(' ') + ui::shortTime(snapshot.time)).toStdString();
    snapshot.frame = frame;
    snapshot.cameraFromPatient = result.cameraFromPatient;
    snapshot.metrics = core::metricsOf(result);
    snapshot.runMs = result.time.totalMs;
    return snapshot;
}

}   // namespace angiopose::app
