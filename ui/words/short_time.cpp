#include "ui/words/short_time.h"

#include "ui/words/language.h"

#include <QDateTime>

namespace angiopose::ui {

QString shortTime(const std::string& isoTime)
{
    const QDateTime time = QDateTime::fromString(QString::fromStdString(isoTime), Qt::ISODate).toLocalTime();
    if (!time.isValid()) {
        return {};
    }
    const QLocale locale = languageLocale();
    const QString clock = locale.toString(time.time(), QStringLiteral("HH:mm"));
    return time.date() == QDate::currentDate()
               ? clock
               : locale.toString(time.date(), QLocale::ShortFormat) + QLatin1Char(' ') + clock;
}

}   // namespace angiopose::ui
