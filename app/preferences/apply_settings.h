#pragma once

#include <QApplication>
#include <QCommandLineOption>
#include <QCommandLineParser>

namespace angiopose::app {

/// Applies the user's language. Call it before the first window is created; otherwise, strings already shown must be
/// set again.
void applyLanguageSetting();

/// Shows the user's shortcuts on buttons and in tooltips. Strings already shown must be set again.
void applyShortcutSettings();

/// Applies the user's theme. Call it before the first window is created and after each change.
void applyThemeSetting(QApplication& application);

/// Returns the option `--renderer=auto|vtk|painter`, which selects the renderer of the angiogram's overlay.
QCommandLineOption rendererOption();

/// Returns the value of `--renderer` on the command line.
QString rendererOf(const QCommandLineParser& parser);

/// Applies `--renderer`; returns false if it does not name a renderer.
bool applyRenderer(const QCommandLineParser& parser);

}   // namespace angiopose::app
