#pragma once

#include <QCommandLineOption>
#include <QCommandLineParser>

namespace angiopose::app {

/// `--renderer=auto|vtk|painter`: who draws the angiogram's overlay.
QCommandLineOption rendererOption();

/// What the command line says of it.
QString rendererIn(const QCommandLineParser& parser);

/// Follows it; false when it names no renderer.
bool applyRenderer(const QCommandLineParser& parser);

}   // namespace angiopose::app
