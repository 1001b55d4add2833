#include "ui/scenes/gl_window.h"

#include <GL/glew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRect.h>

#include <algorithm>

namespace angiopose::ui {
namespace {

// Debian builds GLEW for GLX. On an EGL context, it loads every entry point and only then fails to find a GLX display.
constexpr GLenum glewNoGlxDisplay = 4;

}   // namespace

vtkStandardNewMacro(GlWindow)

    GlWindow::GlWindow()
{
    SetOwnContext(0);
    SetFrameBlitModeToNoBlit();
    SetReadyForRendering(false);
    SetMultiSamples(0);
}

void GlWindow::OpenGLInitContext()
{
    if (Initialized) {
        return;
    }
    glewExperimental = GL_TRUE;
    const GLenum outcome = glewInit();
    if (outcome != GLEW_OK && outcome != glewNoGlxDisplay) {
        Superclass::OpenGLInitContext();
        return;
    }
    ContextCreationTime.Modified();
    GlewInitValid = true;
    Initialized = true;
    GLfloat widths[2] = {1.0F, 1.0F};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    MaximumHardwareLineWidth = widths[1];
}

void GlWindow::resetState()
{
    GetState()->Reset();
    GetState()->vtkglDepthFunc(GL_LEQUAL);   // draws later lines of equal depth on top
}

void GlWindow::readPixels(Canvas canvas)
{
    ReadPixels(vtkRecti(0, 0, canvas.width, canvas.height), 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, canvas.pixels, 0);
    for (int top = 0, bottom = canvas.height - 1; top < bottom; ++top, --bottom) {   // OpenGL starts at the bottom row
        std::swap_ranges(canvas.row(top), canvas.row(top) + canvas.width, canvas.row(bottom));
    }
    std::uint32_t* pixels = canvas.pixels;
    std::transform(pixels, pixels + canvas.pixelCount(), pixels, [](std::uint32_t pixel) {
        return 0xFF000000U | pixel;   // sets alpha, since canvas pixels are opaque
    });
}

void GlWindow::releaseOldBuffers()
{
    constexpr int scenesAtATime = 64;   // maximum number of scenes in flight in Mesa
    RenderFramebuffer->Bind();
    for (int i = 0; i < scenesAtATime; ++i) {
        glClear(GL_COLOR_BUFFER_BIT);
        glFlush();
    }
}

}   // namespace angiopose::ui
