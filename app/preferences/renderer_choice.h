#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>

namespace angiopose::app {

/// `--renderer=auto|vtk|painter`: who draws the angiogram's overlay.
QCommandLineOption rendererOption();

/// Follows what the command line says; ends the program with a sentence when it names no renderer.
void applyRenderer(const QCommandLineParser& parser);

}   // namespace angiopose::app
