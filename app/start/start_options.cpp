#include "app/start/start_options.h"

#include "app/preferences/apply_settings.h"
#include "ui/words/language.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

namespace angiopose::app {
namespace {

constexpr std::array besideReport{"register", "template", "author", "identity", "language"};

QString option(const char* name)
{
    return QString::fromLatin1(name);
}

constexpr int exitNoDisplay = 1;
constexpr int exitWrongUsage = 2;

struct ToolkitOption {
    std::string_view name;
    int values = 0;
};

/// Options that QGuiApplication and QApplication remove from the command line, with one or two leading dashes.
constexpr std::array toolkitOptions{
    ToolkitOption{"platform", 1},    ToolkitOption{"platformpluginpath", 1},
    ToolkitOption{"plugin", 1},      ToolkitOption{"platformtheme", 1},
    ToolkitOption{"style", 1},       ToolkitOption{"stylesheet", 1},
    ToolkitOption{"display", 1},     ToolkitOption{"geometry", 1},
    ToolkitOption{"session", 1},     ToolkitOption{"qwindowgeometry", 1},
    ToolkitOption{"qwindowicon", 1}, ToolkitOption{"qwindowtitle", 1},
    ToolkitOption{"reverse", 0},     ToolkitOption{"widgetcount", 0},
    ToolkitOption{"nograb", 0},      ToolkitOption{"dograb", 0},
    ToolkitOption{"sync", 0},
};

/// Returns the number of arguments, starting with this one, that belong to a Qt option; 0 if there is none.
int qtOptionLength(std::string_view word)
{
    const std::string_view name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
    for (const ToolkitOption& option : toolkitOptions) {
        if (word.starts_with('-') && name == option.name) {
            return 1 + option.values;
        }
        if (word.starts_with('-') && name.starts_with(option.name) &&
            name.substr(option.name.size()).starts_with('=')) {
            return 1;
        }
    }
    return 0;
}

/// Returns whether no display is available; Qt would then abort the program.
bool hasNoDisplay()
{
#ifdef Q_OS_LINUX
    return !qEnvironmentVariableIsSet("DISPLAY") && !qEnvironmentVariableIsSet("WAYLAND_DISPLAY") &&
           !qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return false;
#endif
}

QStringList ownWords(int argc, char** argv)
{
    QStringList words;
    for (int i = 0; i < argc;) {
        const int foreign = i == 0 ? 0 : qtOptionLength(argv[i]);
        if (foreign == 0) {
            words << QString::fromLocal8Bit(argv[i]);
        }
        i += std::max(foreign, 1);
    }
    return words;
}

void describeOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QCoreApplication::translate(
        "main", "Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
                                 QCoreApplication::translate("main", "A case file, or a centerline and an angiogram."),
                                 QStringLiteral("[case|files…]"));
    parser.addOption(rendererOption());
    addReportOptions(parser);
}

int say(std::FILE* stream, const QString& text, int exitCode)
{
    std::fputs(text.toLocal8Bit().constData(), stream);
    return exitCode;
}

/// Prints an answer on the terminal in the UI language; creates a QCoreApplication, which translation requires.
int answer(int argc, char** argv, const QStringList& words)
{
    const QCoreApplication application(argc, argv);
    applyLanguageSetting();
    QCommandLineParser parser;
    describeOptions(parser);
    if (!parser.parse(words)) {
        return say(stderr, parser.errorText() + QLatin1String("\nangiopose --help\n"), exitWrongUsage);
    }
    if (parser.isSet(QStringLiteral("version"))) {
        return say(stdout, QStringLiteral("AngioPose " ANGIOPOSE_VERSION "\n"), 0);
    }
    if (parser.isSet(QStringLiteral("help")) || parser.isSet(QStringLiteral("help-all"))) {
        return say(stdout, parser.helpText(), 0);
    }
    if (!applyRenderer(parser)) {
        const QString text = QCoreApplication::translate("main", "Unknown renderer “%1”. Use auto, vtk or painter.")
                                 .arg(rendererOf(parser));
        return say(stderr, text + QLatin1Char('\n'), exitWrongUsage);
    }
    if (const auto fault = reportOptionsError(parser)) {
        return say(stderr, *fault + QLatin1Char('\n'), exitWrongUsage);
    }
    const QString text = QCoreApplication::translate("main",
                                                     "No display is available for the window. Use angiopose-cli, which "
                                                     "provides the same functions without a display.");
    return say(stderr, text + QLatin1Char('\n'), exitNoDisplay);
}

}   // namespace

void addReportOptions(QCommandLineParser& parser)
{
    parser.addOptions(
        {{option("report"),
          QCoreApplication::translate("main",
                                      "Write the report of a case (.pdf or .html) and exit; requires no display."),
          QStringLiteral("FILE")},
         {option("register"), QCoreApplication::translate("main", "With --report: register the case first.")},
         {option("template"),
          QCoreApplication::translate("main", "With --report: template to use instead of the built-in one."),
          QStringLiteral("FILE.html")},
         {option("author"),
          QCoreApplication::translate("main", "With --report: author to use instead of the account name."),
          QStringLiteral("NAME")},
         {option("identity"),
          QCoreApplication::translate("main", "With --report: include the patient's identity (omitted by default).")},
         {option("language"),
          QCoreApplication::translate("main", "With --report: language to use instead of the UI language."),
          ui::languages().join('|')}});
}

std::optional<QString> reportOptionsError(const QCommandLineParser& parser)
{
    if (!parser.isSet(option("report"))) {
        const auto isSet = [&parser](const char* name) { return parser.isSet(option(name)); };
        return std::ranges::any_of(besideReport, isSet)
                   ? std::optional(QCoreApplication::translate(
                         "main", "--register, --template, --author, --identity and --language require --report FILE."))
                   : std::nullopt;
    }
    const QString path = parser.value(option("report"));
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending != QLatin1String("pdf") && ending != QLatin1String("html") && ending != QLatin1String("htm")) {
        return QCoreApplication::translate("main", "Reports are written as .pdf or .html, not as “%1”.").arg(path);
    }
    if (parser.positionalArguments().size() != 1) {
        return QCoreApplication::translate("main", "A report requires exactly one case: angiopose --report FILE CASE");
    }
    const QString language = parser.value(option("language"));
    if (parser.isSet(option("language")) && !ui::languages().contains(language)) {
        return QCoreApplication::translate("main", "Reports are available in %1, not in “%2”.")
            .arg(ui::languages().join(QStringLiteral(", ")), language);
    }
    return std::nullopt;
}

std::optional<ReportCommandOptions> parseReportOptions(const QCommandLineParser& parser)
{
    if (!parser.isSet(option("report"))) {
        return std::nullopt;
    }
    ReportCommandOptions words;
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

StartOptions parseStartOptions(int argc, char** argv)
{
    QCoreApplication::setOrganizationName(QStringLiteral("AngioPose"));   // needed to read the stored language
    QCoreApplication::setApplicationName(QStringLiteral("AngioPose"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ANGIOPOSE_VERSION));
    const QStringList words = ownWords(argc, argv);
    QCommandLineParser parser;
    describeOptions(parser);
    const bool isAsked = !parser.parse(words) || parser.isSet(QStringLiteral("version")) ||
                         parser.isSet(QStringLiteral("help")) || parser.isSet(QStringLiteral("help-all"));
    if (isAsked || !applyRenderer(parser) || reportOptionsError(parser)) {
        return {{}, answer(argc, argv, words)};
    }
    if (const auto report = parseReportOptions(parser)) {
        return {{}, std::nullopt, report};
    }
    const bool hasQtOptions = words.size() < argc;   // they may select another platform
    if (hasNoDisplay() && !hasQtOptions) {
        return {{}, answer(argc, argv, words)};
    }
    return {parser.positionalArguments()};
}

}   // namespace angiopose::app
