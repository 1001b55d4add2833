#pragma once

#include <QString>

namespace angiopose::ui {

/// Who draws OpenGL here, as the driver itself says; empty where there is no OpenGL 3.2.
struct GlDriver {
    QString vendor;
    QString renderer;
    QString version;

    bool isThere() const { return !renderer.isEmpty(); }
    bool isAccelerated() const;   ///< by a graphics card, not by the processor
};

/// Asked once, on the thread of the user interface.
const GlDriver& glDriver();

/// Who draws the angiogram's overlay. Auto is VTK where OpenGL is accelerated and the painter elsewhere: in software,
/// OpenGL takes several times the painter's time for the same picture.
enum class RendererChoice { Auto, Vtk, Painter };
void chooseRenderer(RendererChoice choice);   ///< before the first picture

/// What the choice and the driver come to.
enum class Renderer { Vtk, Painter };
Renderer chosenRenderer();

}   // namespace angiopose::ui
