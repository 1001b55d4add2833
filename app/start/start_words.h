#pragma once

#include "app/start/report_words.h"

#include <QStringList>

#include <optional>

namespace angiopose::app {

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
