#include "ui/scenes/gl_window.h"

#include <GL/glew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>

namespace ui {
namespace {

// Debian builds GLEW for GLX. On an EGL context it loads every entry point and only then fails to find a GLX display.
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

void GlWindow::takeOverState()
{
    GetState()->Reset();
    GetState()->vtkglDepthFunc(GL_LEQUAL);   // lines of one layer lie at one depth: the later one wins
}

}   // namespace ui
