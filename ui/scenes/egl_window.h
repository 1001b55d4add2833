#pragma once

#include "ui/scenes/gl_window.h"

#include <vtkSmartPointer.h>

namespace ui {

/// Render window without any display: its context is surfaceless EGL, drawn by the processor if need be.
class EglWindow : public GlWindow {
public:
    static EglWindow* New();
    vtkTypeMacro(EglWindow, GlWindow)

        /// A window ready to render, or nothing when the system offers no OpenGL 3.2 through EGL.
        static vtkSmartPointer<EglWindow> create();

    void MakeCurrent() override;
    bool IsCurrent() override;

protected:
    EglWindow() = default;
    ~EglWindow() override;

private:
    bool openContext();

    // EGLDisplay and EGLContext are pointers; kept untyped so that EGL headers stay in the source.
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}   // namespace ui
