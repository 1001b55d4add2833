#include "app/showing/notices.h"

#include "ui/dialogs/message_dialog.h"
#include "ui/main_window.h"

#include <QCoreApplication>
#include <QDateTime>

namespace angiopose::app {

using namespace std::chrono_literals;

Notices::Notices(ui::MainWindow& window, std::function<bool()> isBusy, QObject* parent)
    : QObject(parent), window_(window), isBusy_(std::move(isBusy))
{
    noteTimer_.setSingleShot(true);
    connect(&noteTimer_, &QTimer::timeout, this, [this] {
        if (!isBusy_()) {
            window_.strip().showIdle(tr("Ready"));
        }
    });
}

void Notices::showNote(const QString& note)
{
    if (isBusy_()) {
        window_.strip().showStatus(note);
        return;
    }
    window_.strip().showIdle(note);
    noteTimer_.start(6s);
}

void Notices::showProblem(const QString& heading, const QString& reason, const QStringList& paths)
{
    window_.strip().remember(QStringLiteral("%1: %2").arg(heading, reason));
    QStringList details{tr("AngioPose %1").arg(QCoreApplication::applicationVersion()),
                        QDateTime::currentDateTime().toString(Qt::ISODate)};
    details += paths;
    ui::MessageDialog::show({heading, reason, details.join(QLatin1Char('\n'))}, &window_);
}

}   // namespace angiopose::app