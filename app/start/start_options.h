#pragma once

#include "app/texts/case_texts.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

namespace angiopose::app {

/// Command-line options of a report.
struct ReportCommandOptions {
    QString casePath;
    QString outputPath;   ///< path with the extension .pdf, .html or .htm
    bool isRegistered = false;   ///< whether to register the views of the case first
    QString templatePath;   ///< if empty, the built-in template is used
    std::optional<QString> author;   ///< author of the report; if not set, the login name
    Identity identity = Identity::Hidden;
    QString language;   ///< code from `ui::languages`; if empty, the language of the program
};

/// Adds `--report FILE` and the options that go with it.
void addReportOptions(QCommandLineParser& parser);

/// Describes the error in the report options, in the UI language; nullopt if the options are valid or no report is
/// requested.
std::optional<QString> reportOptionsError(const QCommandLineParser& parser);

/// Returns the report options; nullopt if no report was requested.
std::optional<ReportCommandOptions> parseReportOptions(const QCommandLineParser& parser);

/// Startup options from the command line.
struct StartOptions {
    QStringList files;
    std::optional<int> exitCode =
        std::nullopt;   ///< if set, the command line has been handled and the program exits with this code
    std::optional<ReportCommandOptions> report =
        std::nullopt;   ///< if set, write this report instead of opening a window
};

/// Parses the command line before an application, a window or a display connection exists, and handles `--help`,
/// `--version` and errors on the terminal. Options of Qt itself (`-platform`, `-style`, …) are left to Qt.
StartOptions parseStartOptions(int argc, char** argv);

}   // namespace angiopose::app
