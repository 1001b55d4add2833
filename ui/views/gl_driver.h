#pragma once

#include <QString>

namespace angiopose::ui {

/// Identification strings reported by the OpenGL driver; empty without OpenGL 3.2.
struct GlDriver {
    QString vendor;
    QString renderer;
    QString version;

    bool isAvailable() const { return !renderer.isEmpty(); }
    bool isAccelerated() const;   ///< true if a graphics card renders, false if the CPU does
};

/// Returns the OpenGL driver, which is queried once, on the GUI thread.
const GlDriver& glDriver();

/// User's choice of the renderer for the angiogram with overlay. Auto selects VTK if OpenGL is accelerated, otherwise
/// the painter, since software OpenGL takes several times as long to render the same image.
enum class RendererChoice { Auto, Vtk, Painter };
void chooseRenderer(RendererChoice choice);   ///< call before the first rendering

/// Renderer in use, determined by the choice and the driver.
enum class Renderer { Vtk, Painter };
Renderer chosenRenderer();

}   // namespace angiopose::ui
