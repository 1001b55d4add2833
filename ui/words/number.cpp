#include "ui/words/number.h"

#include "ui/words/language.h"

#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr QChar minusSign{0x2212};

QString signedAs(QString digits)
{
    const QString sign = languageLocale().decimalPoint();
    return sign == QLatin1String(".") ? digits : digits.replace(QLatin1Char('.'), sign);
}

}   // namespace

QString numberText(double value, int decimals)
{
    const QString digits = QString::number(value, 'f', decimals);
    if (!digits.startsWith(QLatin1Char('-'))) {
        return signedAs(digits);
    }
    const bool isZero = digits.toDouble() == 0.0;   // omits the sign of "-0.0"
    return signedAs(isZero ? digits.mid(1) : minusSign + digits.mid(1));
}

QString briefNumber(double value, int digits)
{
    return signedAs(QString::number(value, 'g', digits));
}

std::optional<double> numberFrom(QString typed)
{
    typed.replace(minusSign, QLatin1Char('-')).replace(QLatin1Char(','), QLatin1Char('.'));
    bool isNumber = false;
    const double value = typed.trimmed().toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString withDecimalSign(const QString& text)
{
    static const QRegularExpression numbersAlone(QRegularExpression::anchoredPattern(
        QStringLiteral("(?:(?:[-+±−×]?[0-9]+(?:\\.[0-9]+)?[°%]?|mm|px|mm/px|%|ml|s|ms|HU|°|×|LAO|RAO|CRA|CAU|SID|SOD)"
                       "(?: · | |,\\s|$))+")));
    return numbersAlone.match(text).hasMatch() ? signedAs(text) : text;
}

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
