#pragma once

#include "app/texts/case_texts.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

namespace angiopose::app {

/// Options of the command line for a report.
struct ReportWords {
    QString casePath;
    QString outputPath;   ///< ends in .pdf, .html or .htm
    bool isRegistered = false;   ///< the views of the case are registered first
    QString templatePath;   ///< empty: the built-in template
    std::optional<QString> author;   ///< not set: the login name
    Identity identity = Identity::Hidden;
    QString language;   ///< a code of `ui::languages`; empty: the language of the window
};

/// Adds `--report FILE` and its related options.
void describeReport(QCommandLineParser& parser);

/// Describes what is wrong with the report options, in the language of the program; empty if they are valid or no
/// report is requested.
std::optional<QString> faultOfReport(const QCommandLineParser& parser);

/// Report options; empty if no report is requested.
std::optional<ReportWords> reportIn(const QCommandLineParser& parser);

/// Startup options from the command line.
struct StartWords {
    QStringList files;
    std::optional<int> exitCode =
        std::nullopt;   ///< set: the command line is already handled and the program exits with this code
    std::optional<ReportWords> report = std::nullopt;   ///< set: write this report instead of opening a window
};

/// Parses the command line before a window, a display or an application exists: `--help`, `--version` and errors are
/// answered on the terminal. Options of Qt itself (`-platform`, `-style`, …) are left to Qt.
StartWords readStartWords(int argc, char** argv);

}   // namespace angiopose::app
