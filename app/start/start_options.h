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
    QString outputPath;   ///< has the extension .pdf, .html or .htm
    bool isRegistered = false;   ///< register the views of the case first
    QString templatePath;   ///< if empty, the built-in template is used
    std::optional<QString> author;   ///< if not set, the login name
    Identity identity = Identity::Hidden;
    QString language;   ///< code from `ui::languages`; if empty, the language of the window
};

/// Adds `--report FILE` and the options that go with it.
void addReportOptions(QCommandLineParser& parser);

/// Describes the error in the report options, in the language of the program; empty if the options are valid or no
/// report is requested.
std::optional<QString> reportOptionsError(const QCommandLineParser& parser);

/// Returns the report options; empty if no report is requested.
std::optional<ReportCommandOptions> parseReportOptions(const QCommandLineParser& parser);

/// Startup options from the command line.
struct StartOptions {
    QStringList files;
    std::optional<int> exitCode =
        std::nullopt;   ///< if set, the command line has been handled and the program exits with this code
    std::optional<ReportCommandOptions> report =
        std::nullopt;   ///< if set, write this report instead of opening a window
};

/// Parses the command line before a window, a display connection or an application exists, and handles `--help`,
/// `--version` and errors on the terminal. Options of Qt itself (`-platform`, `-style`, …) are left to Qt.
StartOptions parseStartOptions(int argc, char** argv);

}   // namespace angiopose::app
