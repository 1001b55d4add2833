#include "ui/scenes/egl_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <vtkObjectFactory.h>

namespace ui {
namespace {

EGLDisplay surfacelessDisplay()
{
    const auto getDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return getDisplay ? getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr) : EGL_NO_DISPLAY;
}

EGLConfig configOf(EGLDisplay display)
{
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    return count > 0 ? config : EGL_NO_CONFIG_KHR;
}

}   // namespace

vtkStandardNewMacro(EglWindow)

    vtkSmartPointer<EglWindow> EglWindow::create()
{
    auto window = vtkSmartPointer<EglWindow>::New();
    return window->openContext() ? window : nullptr;
}

bool EglWindow::openContext()
{
    display_ = surfacelessDisplay();
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) {
        return false;
    }
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, configOf(display_), EGL_NO_CONTEXT, attributes);
    if (!context_) {
        return false;
    }
    MakeCurrent();
    if (!IsCurrent()) {
        return false;
    }
    SetReadyForRendering(true);
    OpenGLInitContext();
    return Initialized;
}

void EglWindow::MakeCurrent()
{
    if (context_) {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
    }
}

bool EglWindow::IsCurrent()
{
    return context_ && eglGetCurrentContext() == context_;
}

EglWindow::~EglWindow()
{
    Finalize();
    // The display is shared by the whole process and stays open.
    if (context_) {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }
}

}   // namespace ui
