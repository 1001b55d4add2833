#include "ui/views/gl_overlay.h"

#include "ui/scenes/gl_window.h"
#include "ui/views/offscreen_context.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace angiopose::ui {

struct GlOverlay::Parts {
    OffscreenContext context;
    vtkNew<GlWindow> window;
    VtkOverlay overlay;
    bool isReady = false;

    void answer(unsigned long event, void (*reaction)(vtkObject*, unsigned long, void*, void*))
    {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(reaction);
        command->SetClientData(&context);
        window->AddObserver(event, command);
    }
};

GlOverlay::GlOverlay() : parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    p.answer(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* client, void*) {
        static_cast<OffscreenContext*>(client)->makeCurrent();
    });
    p.answer(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* client, void* answer) {
        *static_cast<bool*>(answer) = static_cast<OffscreenContext*>(client)->isCurrent();
    });
    p.overlay.attachTo(p.window);
    p.isReady = p.context.create() && p.context.makeCurrent();
    if (p.isReady) {
        p.window->resetState();
        p.window->SetReadyForRendering(true);
        p.window->OpenGLInitContext();
        p.context.doneCurrent();
    }
}

GlOverlay::~GlOverlay()
{
    if (parts_->isReady && parts_->context.makeCurrent()) {
        parts_->window->Finalize();
        parts_->context.doneCurrent();
    }
    parts_->window->RemoveAllObservers();
}

bool GlOverlay::isReady() const
{
    return parts_->isReady;
}

void GlOverlay::draw(const OverlayScene& scene, bool isMirrored, const StrokeMesh& above, Canvas canvas)
{
    Parts& p = *parts_;
    p.context.makeCurrent();
    p.window->SetSize(canvas.width, canvas.height);
    p.overlay.show(scene, isMirrored, above);
    p.window->resetState();
    p.window->Render();
    p.window->readPixels(canvas);
    p.context.doneCurrent();
}

VtkOverlay::RenderStats GlOverlay::renderStats() const
{
    return parts_->overlay.renderStats();
}

}   // namespace angiopose::ui
