#include "ui/words/core_texts.h"

#include "ui/words/language.h"
#include "ui/words/number.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <vector>

namespace angiopose::ui {
namespace {

QString translatedText(const char* source)
{
    return QCoreApplication::translate("core", source);
}

/// A sentence with holes, able to recognise what was made of it.
struct Template {
    const char* source;
    QString head, tail;   ///< before the first and after the last hole: most sentences are told apart by these
    QRegularExpression pattern;
};

const QRegularExpression& hole()
{
    static const QRegularExpression expression(QStringLiteral("%[0-9]+"));
    return expression;
}

Template templateOf(const char* source)
{
    const QStringList parts = QString::fromUtf8(source).split(hole());
    QStringList escaped;
    for (const QString& part : parts) {
        escaped << QRegularExpression::escape(part);
    }
    const QString pattern = QRegularExpression::anchoredPattern(escaped.join(QStringLiteral("(.*?)")));
    return {source, parts.front(), parts.back(),
            QRegularExpression(pattern, QRegularExpression::DotMatchesEverythingOption)};
}

/// The sentence that says most by itself comes first.
std::vector<Template> makeTemplates()
{
    std::vector<const char*> sources;
    std::ranges::copy_if(coreTexts(), std::back_inserter(sources),
                         [](const char* text) { return QString::fromUtf8(text).contains(hole()); });
    std::ranges::stable_sort(sources, [](const char* a, const char* b) { return qstrlen(a) > qstrlen(b); });
    std::vector<Template> templates;
    templates.reserve(sources.size());
    for (const char* source : sources) {
        templates.push_back(templateOf(source));
    }
    return templates;
}

QHash<QString, const char*> makeWholeTexts()
{
    QHash<QString, const char*> texts;
    for (const char* text : coreTexts()) {
        texts.insert(QString::fromUtf8(text), text);
    }
    return texts;
}

/// The template's translation with what stood in its holes, itself translated.
QString filled(const char* source, const QRegularExpressionMatch& match)
{
    QString result;
    const QString words = translatedText(source);
    qsizetype end = 0;
    for (auto holes = hole().globalMatch(words); holes.hasNext();) {
        const QRegularExpressionMatch place = holes.next();
        result += words.mid(end, place.capturedStart() - end);
        result += coreText(match.captured(place.captured().mid(1).toInt()));
        end = place.capturedEnd();
    }
    return result + words.mid(end);
}

/// "0.39 mm/px at the detector · 0.31 mm/px at the vessels" are two parts, not one with a long number.
bool joinsParts(const Template& candidate, const QRegularExpressionMatch& match)
{
    const QString separator = QStringLiteral(" · ");
    const QStringList captured = match.capturedTexts().mid(1);
    return !QString::fromUtf8(candidate.source).contains(separator) &&
           std::ranges::any_of(captured, [&](const QString& hole) { return hole.contains(separator); });
}

std::optional<QString> translatedSentence(const QString& text)
{
    static const QHash<QString, const char*> wholeTexts = makeWholeTexts();
    static const std::vector<Template> templates = makeTemplates();
    if (const char* source = wholeTexts.value(text)) {
        return translatedText(source);
    }
    for (const Template& candidate : templates) {
        if (text.startsWith(candidate.head) && text.endsWith(candidate.tail)) {
            if (const auto match = candidate.pattern.match(text); match.hasMatch() && !joinsParts(candidate, match)) {
                return filled(candidate.source, match);
            }
        }
    }
    return std::nullopt;
}

/// A list of sentences, each of them known.
std::optional<QString> translatedSentences(const QString& text)
{
    const qsizetype place = text.indexOf(QLatin1String(". "));
    if (place < 0) {
        return translatedSentence(text);
    }
    const auto first = translatedSentence(text.left(place + 1));
    const auto rest = first ? translatedSentences(text.mid(place + 2)) : std::nullopt;
    return rest ? std::optional(joinedSentences({*first, *rest})) : std::nullopt;
}

/// "720 mm (header)": a known word in brackets at the end.
std::optional<QString> translatedBracket(const QString& text)
{
    const qsizetype open = text.lastIndexOf(QLatin1Char('('));
    if (open < 0 || !text.endsWith(QLatin1Char(')'))) {
        return std::nullopt;
    }
    const auto word = translatedSentence(text.mid(open + 1, text.size() - open - 2));
    return word ? std::optional(text.left(open + 1) + *word + QLatin1Char(')')) : std::nullopt;
}

/// Both sides of the first separator at which one of them is known.
std::optional<QString> translatedParts(const QString& text, const QString& separator)
{
    for (qsizetype place = text.indexOf(separator); place >= 0; place = text.indexOf(separator, place + 1)) {
        const qsizetype next = place + separator.size();
        const QString before = text.left(place + (separator.startsWith(QLatin1Char('.')) ? 1 : 0));
        const QString after = text.mid(next);
        if (translatedSentence(before) || translatedSentence(after) || translatedBracket(after)) {
            return coreText(before) + text.mid(before.size(), next - before.size()) + coreText(after);
        }
    }
    return std::nullopt;
}

}   // namespace

QString coreText(std::string_view text)
{
    return coreText(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())));
}

QString coreText(const QString& text)
{
    for (const auto translate : {translatedSentences, translatedSentence}) {
        if (auto sentence = translate(text)) {
            return *sentence;
        }
    }
    if (text.contains(QLatin1Char('\n'))) {
        QStringList lines = text.split(QLatin1Char('\n'));
        std::ranges::transform(lines, lines.begin(), [](const QString& line) { return coreText(line); });
        return lines.join(QLatin1Char('\n'));
    }
    for (const char* separator : {". ", ": ", " · "}) {
        if (auto parts = translatedParts(text, QString::fromUtf8(separator))) {
            return *parts;
        }
    }
    return translatedBracket(text).value_or(withDecimalSign(text));
}

}   // namespace angiopose::ui