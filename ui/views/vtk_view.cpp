#include "ui/views/vtk_view.h"

#include "ui/scenes/gl_window.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include <vector>

namespace ui {
namespace {

QSurfaceFormat surfaceFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);   // VTK multisamples in its own framebuffer
    return format;
}

}   // namespace

struct VtkView::Glue {
    vtkNew<GlWindow> window;
    std::vector<unsigned long> observers;
    QSurface* surface = nullptr;   // of the context VTK draws with
    QMetaObject::Connection contextGoes;

    void observe(unsigned long event, void* client, void (*reaction)(vtkObject*, unsigned long, void*, void*))
    {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(reaction);
        command->SetClientData(client);
        observers.push_back(window->AddObserver(event, command));
    }
};

VtkView::VtkView(QWidget* parent) : QOpenGLWidget(parent), glue_(std::make_unique<Glue>())
{
    setFormat(surfaceFormat());
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);   // a dock would otherwise squeeze the view to nothing

    // Not QOpenGLWidget::makeCurrent(): that binds Qt's framebuffer behind the back of VTK's state cache.
    glue_->observe(vtkCommand::WindowMakeCurrentEvent, this, [](vtkObject*, unsigned long, void* client, void*) {
        auto* self = static_cast<VtkView*>(client);
        if (self->glue_->surface) {
            self->context()->makeCurrent(self->glue_->surface);
        }
    });
    glue_->observe(vtkCommand::WindowIsCurrentEvent, this, [](vtkObject*, unsigned long, void* client, void* answer) {
        const auto* self = static_cast<VtkView*>(client);
        *static_cast<bool*>(answer) = self->glue_->surface && QOpenGLContext::currentContext() == self->context() &&
                                      self->context()->surface() == self->glue_->surface;
    });
    glue_->observe(vtkCommand::WindowFrameEvent, this, [](vtkObject*, unsigned long, void* client, void*) {
        auto* self = static_cast<VtkView*>(client);
        if (!self->isPainting_) {
            self->update();
        }
    });
}

VtkView::~VtkView()
{
    releaseContext();
    for (const unsigned long observer : glue_->observers) {
        glue_->window->RemoveObserver(observer);
    }
}

vtkRenderWindow* VtkView::renderWindow() const
{
    return glue_->window;
}

QSize VtkView::deviceSize() const
{
    return (size() * devicePixelRatio()).expandedTo({1, 1});
}

void VtkView::paintAnnotations(QPainter&) {}

void VtkView::initializeGL()
{
    ++contextCount_;
    glue_->surface = context()->surface();
    glue_->contextGoes =
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkView::releaseContext, Qt::DirectConnection);
    glue_->window->takeOverState();
    glue_->window->SetReadyForRendering(true);
    glue_->window->OpenGLInitContext();
}

void VtkView::releaseContext()
{
    disconnect(glue_->contextGoes);
    if (!glue_->window->GetReadyForRendering()) {
        return;
    }
    makeCurrent();
    glue_->window->Finalize();
    glue_->window->SetReadyForRendering(false);
    glue_->surface = nullptr;
    doneCurrent();
}

void VtkView::paintGL()
{
    if (isPainting_) {
        return;
    }
    isPainting_ = true;
    const QSize device = deviceSize();
    glue_->window->SetSize(device.width(), device.height());
    prepareFrame();
    glue_->window->takeOverState();
    auto* state = glue_->window->GetState();
    state->Push();
    glue_->window->Render();
    ++renderCount_;
    makeCurrent();   // an observer may have switched contexts
    blitToWidget();
    state->Pop();
    makeCurrent();   // binds the widget's framebuffer again
    paintOverOpenGl();
    isPainting_ = false;
}

void VtkView::paintOverOpenGl()
{
    // Not QPainter(this): when a parent is grabbed, Qt would send that paint to the parent's picture, under the view.
    QOpenGLPaintDevice device(deviceSize());
    device.setDevicePixelRatio(devicePixelRatio());
    QPainter painter(&device);
    // The paint engine takes up its own OpenGL state anew only after native painting; VTK changed all of it.
    painter.beginNativePainting();
    painter.endNativePainting();
    paintAnnotations(painter);
}

void VtkView::blitToWidget()
{
    auto* state = glue_->window->GetState();
    auto* gl = context()->extraFunctions();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    const GLenum target = GL_COLOR_ATTACHMENT0;
    gl->glDrawBuffers(1, &target);
    state->vtkglDisable(GL_SCISSOR_TEST);
    gl->glDisable(GL_SCISSOR_TEST);
    const int* size = glue_->window->GetRenderFramebuffer()->GetLastSize();
    glue_->window->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                                          GL_NEAREST);
    // The compositor would let the desktop shine through where alpha is below one.
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}   // namespace ui
