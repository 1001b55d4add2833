#pragma once

#include "ui/scenes/canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>

namespace angiopose::ui {

/// Render window on a context that somebody else owns, GLX or EGL alike.
class GlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GlWindow* New();
    vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

        void OpenGLInitContext() override;
    void Frame() override {}   // would copy for a display that there is not

    /// Before every render: others have used the context since, VTK's record of its state is out of date.
    void takeOverState();

    /// What was rendered last, into a canvas of the window's size.
    void readPicture(Canvas canvas);

    /// After the last picture for a while. In software, OpenGL draws several scenes at a time and keeps the buffers of
    /// each, of whatever size the window had, until the next one of its kind: a few empty ones take their places.
    void letGoOfOldBuffers();

protected:
    GlWindow();
};

}   // namespace angiopose::ui