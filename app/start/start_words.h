#pragma once

#include "app/texts/case_texts.h"

#include <QCommandLineParser>
#include <QString>
#include <QStringList>
#include <optional>

namespace angiopose::app {

/// What the command line wants of a report.
struct ReportWords {
    QString casePath;
    QString outputPath;   ///< ends in .pdf, .html or .htm
    bool isRegistered = false;   ///< the views of the case are registered first
    QString templatePath;   ///< empty: the built-in one
    std::optional<QString> author;   ///< not set: who is logged in
    Identity identity = Identity::Hidden;
    QString language;   ///< a code of `ui::languages`; empty: the window's
};

/// Adds `--report FILE` and what goes beside it.
void describeReport(QCommandLineParser& parser);

/// What is wrong with the words about a report, in the language of the program; nothing where they can be followed, or
/// no report is asked for.
std::optional<QString> faultOfReport(const QCommandLineParser& parser);

/// Nothing where no report is asked for.
std::optional<ReportWords> reportIn(const QCommandLineParser& parser);

/// What the command line wants the window to begin with.
struct StartWords {
    QStringList files;
    std::optional<int> exitCode = std::nullopt;   ///< answered already: the program ends with it
    std::optional<ReportWords> report = std::nullopt;   ///< written instead of a window's being opened
};

/// Reads the command line before there is a window, a display or an application: `--help`, `--version` and what is
/// wrong are answered on the terminal. Options of Qt itself (`-platform`, `-style`, …) are left for it.
StartWords readStartWords(int argc, char** argv);

}   // namespace angiopose::app
