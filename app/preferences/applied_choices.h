#pragma once

#include <QApplication>
#include <QCommandLineOption>
#include <QCommandLineParser>

namespace angiopose::app {

/// Applies the language that the user chose. Call it before the first window is created; later, texts that are already
/// shown must be set again.
void applyChosenLanguage();

/// Shows the user's shortcuts on buttons and in tooltips. Texts that are already shown must be set again.
void applyChosenKeys();

/// Applies the theme that the user chose. Called before the first window is created and after each new choice.
void applyChosenTheme(QApplication& application);

/// `--renderer=auto|vtk|painter`: renderer of the angiogram's overlay.
QCommandLineOption rendererOption();

/// Value of this option on the command line.
QString rendererIn(const QCommandLineParser& parser);

/// Applies this option; false if it does not name a renderer.
bool applyRenderer(const QCommandLineParser& parser);

}   // namespace angiopose::app
