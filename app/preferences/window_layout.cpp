#include "app/preferences/window_layout.h"

#include "app/preferences/settings.h"
#include "ui/main_window.h"

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QScreen>

namespace angiopose::app {
namespace {

/// Returns the settings key for the current set of screens and their arrangement.
QString screensKey()
{
    QByteArray text;
    for (const QScreen* screen : QGuiApplication::screens()) {
        const QRect place = screen->geometry();
        text += screen->name().toUtf8() + QByteArray::number(place.x()) + ',' + QByteArray::number(place.y()) + ',' +
                QByteArray::number(place.width()) + ',' + QByteArray::number(place.height()) + ',' +
                QByteArray::number(screen->devicePixelRatio()) + ';';
    }
    const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha1).toHex().left(12);
    return QStringLiteral("window/layouts/") + QString::fromLatin1(hash);
}

}   // namespace

void restoreWindowLayout(ui::MainWindow& window)
{
    const QVariant here = QSettings().value(screensKey());
    const QByteArray layout = here.isValid() ? here.toByteArray() : settings::windowLayout.read();
    if (!layout.isEmpty()) {
        window.restoreLayout(layout);
    }
}

void storeWindowLayout(const ui::MainWindow& window)
{
    const QByteArray layout = window.layoutState();
    QSettings().setValue(screensKey(), layout);
    settings::windowLayout.write(layout);
}

}   // namespace angiopose::app
