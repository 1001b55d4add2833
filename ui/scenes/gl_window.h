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
    void Frame() override {}   // no-op: the base class would swap buffers of a nonexistent display

    /// Call before every render: others have used the context, which makes VTK's cached state invalid.
    void takeOverState();

    /// Copies the last rendered image to a canvas of the same size as the window.
    void readPicture(Canvas canvas);

    /// Call after the last image for a while. Software OpenGL draws several scenes at a time and keeps the buffers of
    /// each, at any earlier window size, until the slot is reused; a few empty scenes release them.
    void letGoOfOldBuffers();

protected:
    GlWindow();
};

}   // namespace angiopose::ui
