#pragma once

#include "ui/scenes/canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>

namespace angiopose::ui {

/// Render window on an externally owned context, GLX or EGL.
class GlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GlWindow* New();
    vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

        void OpenGLInitContext() override;
    void Frame() override {}   // would swap buffers of a display that does not exist

    /// Call before every render: others have used the context, which makes VTK's cached state invalid.
    void takeOverState();

    /// Copies the last rendered image to a canvas of the window's size.
    void readPicture(Canvas canvas);

    /// Call after the last image for a while. Software OpenGL draws several scenes at a time and keeps the buffers of
    /// each, at any earlier window size, until the slot is reused; a few empty scenes release them.
    void letGoOfOldBuffers();

protected:
    GlWindow();
};

}   // namespace angiopose::ui