#include "ui/words/message_text.h"

#include "ui/words/language.h"
#include "ui/words/number.h"

#include <QCoreApplication>

#include <algorithm>

namespace angiopose::ui {
namespace {

QString fromText(const std::string& text)
{
    return QString::fromStdString(text);
}

/// Joins strings as sentences if any ends with a period, otherwise as list items.
QString rowOf(const QStringList& texts)
{
    const bool areSentences = std::ranges::any_of(
        texts, [](const QString& text) { return text.endsWith(QLatin1Char('.')) || text.endsWith(QChar(0x3002)); });
    return areSentences ? joinSentences(texts) : joinNames(texts);
}

struct ArgumentWords {
    QString operator()(const std::string& text) const { return fromText(text); }

    QString operator()(const core::Quantity& quantity) const
    {
        const QString number = quantity.decimals == core::Quantity::significantDigits
                                   ? briefNumber(quantity.value, 6)
                                   : numberText(quantity.value, quantity.decimals);
        const QString unit = QString::fromUtf8(quantity.unit);
        const bool isApart = !unit.isEmpty() && unit != QStringLiteral("°");
        return number + (isApart ? QStringLiteral(" ") : QString()) + unit;
    }

    QString operator()(const std::vector<std::string>& texts) const
    {
        QStringList names;
        std::ranges::transform(texts, std::back_inserter(names), fromText);
        return joinNames(names);
    }

    QString operator()(const core::Messages& messages) const
    {
        QStringList texts;
        for (const core::Message& message : messages) {
            texts << messageText(message);
        }
        return rowOf(texts);
    }
};

/// Returns the translated sentence with %1, %2, … replaced by the arguments.
QString filled(const QString& words, const std::vector<core::MessageArgument>& arguments)
{
    QString sentence;
    for (qsizetype at = 0; at < words.size(); ++at) {
        const int argumentNumber =
            words[at] == QLatin1Char('%') && at + 1 < words.size() ? words[at + 1].digitValue() : -1;
        if (argumentNumber >= 1 && static_cast<std::size_t>(argumentNumber) <= arguments.size()) {
            sentence += std::visit(ArgumentWords(), arguments[static_cast<std::size_t>(argumentNumber) - 1]);
            ++at;
        } else {
            sentence += words[at];
        }
    }
    return sentence;
}

}   // namespace

QString messageText(const core::Message& message)
{
    const core::MessageEntry& entry = message.entry();
    const QString sentence =
        filled(QCoreApplication::translate("messages", entry.english, entry.id), message.arguments());
    return message.subject().empty() ? sentence : fromText(message.subject()) + QStringLiteral(": ") + sentence;
}

QString messagesText(const core::Messages& messages)
{
    QStringList sentences;
    for (const core::Message& message : messages) {
        sentences << messageText(message);
    }
    return joinSentences(sentences);
}

QString messageText(const std::optional<core::Message>& message)
{
    return message ? messageText(*message) : QString();
}

}   // namespace angiopose::ui
