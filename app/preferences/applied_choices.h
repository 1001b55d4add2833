#pragma once

#include <QApplication>
#include <QCommandLineOption>
#include <QCommandLineParser>

namespace angiopose::app {

/// Makes the program speak as the user chose. Before the first window is made; later, what is said already has to be
/// said again.
void applyChosenLanguage();

/// Makes buttons and hints name the keys that the user chose. What is said already has to be said again.
void applyChosenKeys();

/// Dresses the application as the user chose. Called before the first window is made, and again after a new choice.
void applyChosenTheme(QApplication& application);

/// `--renderer=auto|vtk|painter`: who draws the angiogram's overlay.
QCommandLineOption rendererOption();

/// What the command line says of it.
QString rendererIn(const QCommandLineParser& parser);

/// Follows it; false when it names no renderer.
bool applyRenderer(const QCommandLineParser& parser);

}   // namespace angiopose::app
