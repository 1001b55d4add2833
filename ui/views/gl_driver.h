#pragma once

#include <QString>

namespace angiopose::ui {

/// OpenGL driver as reported by itself; empty without OpenGL 3.2.
struct GlDriver {
    QString vendor;
    QString renderer;
    QString version;

    bool isThere() const { return !renderer.isEmpty(); }
    bool isAccelerated() const;   ///< by a graphics card, not by the CPU
};

/// Queried once, on the UI thread.
const GlDriver& glDriver();

/// Renderer of the angiogram's overlay. Auto selects VTK if OpenGL is accelerated, otherwise the painter: software
/// OpenGL takes several times as long for the same image.
enum class RendererChoice { Auto, Vtk, Painter };
void chooseRenderer(RendererChoice choice);   ///< call before the first rendering

/// Renderer that results from the choice and the driver.
enum class Renderer { Vtk, Painter };
Renderer chosenRenderer();

}   // namespace angiopose::ui
