#include "app/showing/notifications.h"

#include "ui/dialogs/message_dialog.h"
#include "ui/panels/bottom_strip.h"

#include <QCoreApplication>
#include <QDateTime>

namespace angiopose::app {

using namespace std::chrono_literals;

Notifications::Notifications(ui::BottomStrip& strip, QWidget& dialogParent, std::function<bool()> isBusy,
                             QObject* parent)
    : QObject(parent), strip_(strip), dialogParent_(dialogParent), isBusy_(std::move(isBusy))
{
    noteTimer_.setSingleShot(true);
    connect(&noteTimer_, &QTimer::timeout, this, [this] {
        if (!isBusy_()) {
            strip_.showIdle(tr("Ready"));
        }
    });
}

void Notifications::showNote(const QString& note)
{
    if (isBusy_()) {
        strip_.showStatus(note);
        return;
    }
    strip_.showIdle(note);
    noteTimer_.start(6s);
}

void Notifications::showWarnings(const QString& warnings)
{
    showNote(warnings);
    noteTimer_.stop();
}

void Notifications::showProblem(const QString& heading, const QString& reason, const QStringList& paths)
{
    strip_.remember(QStringLiteral("%1: %2").arg(heading, reason));
    QStringList details{tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
                        QDateTime::currentDateTime().toString(Qt::ISODate)};
    details += paths;
    ui::MessageDialog::show({heading, reason, details.join(QLatin1Char('\n'))}, &dialogParent_);
}

}   // namespace angiopose::app
