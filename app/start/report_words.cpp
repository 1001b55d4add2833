#include "app/start/report_words.h"

#include "ui/words/language.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <array>

namespace angiopose::app {
namespace {

constexpr std::array besideReport{"register", "template", "author", "identity", "language"};

QString option(const char* name)
{
    return QString::fromLatin1(name);
}

}   // namespace

void describeReport(QCommandLineParser& parser)
{
    parser.addOptions(
        {{option("report"),
          QCoreApplication::translate("main", "Write the report of a case, .pdf or .html, and end; needs no display."),
          QStringLiteral("FILE")},
         {option("register"), QCoreApplication::translate("main", "Beside --report: register the case first.")},
         {option("template"),
          QCoreApplication::translate("main", "Beside --report: the page to fill in, in place of the built-in one."),
          QStringLiteral("FILE.html")},
         {option("author"),
          QCoreApplication::translate("main", "Beside --report: who makes it, in place of the account's name."),
          QStringLiteral("NAME")},
         {option("identity"),
          QCoreApplication::translate("main", "Beside --report: name the patient, which is left out else.")},
         {option("language"),
          QCoreApplication::translate("main", "Beside --report: its language, in place of the window's."),
          ui::languages().join('|')}});
}

std::optional<QString> faultOfReport(const QCommandLineParser& parser)
{
    if (!parser.isSet(option("report"))) {
        const auto isSet = [&parser](const char* name) { return parser.isSet(option(name)); };
        return std::ranges::any_of(besideReport, isSet)
                   ? std::optional(QCoreApplication::translate(
                         "main",
                         "--register, --template, --author, --identity and --language go beside --report FILE alone."))
                   : std::nullopt;
    }
    const QString path = parser.value(option("report"));
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("pdf") && ending != QLatin1String("html") && ending != QLatin1String("htm")) {
        return QCoreApplication::translate("main", "A report is written as .pdf or .html, not as “%1”.").arg(path);
    }
    if (parser.positionalArguments().size() != 1) {
        return QCoreApplication::translate("main", "A report is of one case: angiopose --report FILE CASE");
    }
    const QString language = parser.value(option("language"));
    if (parser.isSet(option("language")) && !ui::languages().contains(language)) {
        return QCoreApplication::translate("main", "A report is written in %1, not in “%2”.")
            .arg(ui::languages().join(QStringLiteral(", ")), language);
    }
    return std::nullopt;
}

std::optional<ReportWords> reportIn(const QCommandLineParser& parser)
{
    if (!parser.isSet(option("report"))) {
        return std::nullopt;
    }
    ReportWords words;
    words.casePath = parser.positionalArguments().value(0);
    words.outputPath = parser.value(option("report"));
    words.isRegistered = parser.isSet(option("register"));
    words.templatePath = parser.value(option("template"));
    if (parser.isSet(option("author"))) {
        words.author = parser.value(option("author"));
    }
    words.language = parser.value(option("language"));
    words.identity = parser.isSet(option("identity")) ? Identity::Shown : Identity::Hidden;
    return words;
}

}   // namespace angiopose::app
