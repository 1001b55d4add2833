#pragma once

#include "ui/scenes/canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>

namespace angiopose::ui {

/// VTK render window that uses an external OpenGL context (GLX or EGL).
class GlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GlWindow* New();
    vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

        void OpenGLInitContext() override;
    void Frame() override {}   // does nothing: the base class would swap buffers of a nonexistent display

    /// Call before every rendering, because other code may have changed the OpenGL state that VTK caches.
    void resetState();

    /// Copies the last rendered image to a canvas of the same size as the window.
    void readPixels(Canvas canvas);

    /// Call when rendering pauses. Software OpenGL keeps several scenes in flight, whose buffers of earlier window
    /// sizes persist until their slots are reused; drawing a few empty scenes releases these buffers.
    void releaseOldBuffers();

protected:
    GlWindow();
};

}   // namespace angiopose::ui
