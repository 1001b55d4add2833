#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace ui {

/// Render window on a context that somebody else owns, GLX or EGL alike.
class GlWindow : public vtkGenericOpenGLRenderWindow {
public:
    static GlWindow* New();
    vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

        void OpenGLInitContext() override;

    /// Before every render: others have used the context since, VTK's record of its state is out of date.
    void takeOverState();

protected:
    GlWindow();
};

}   // namespace ui
