#include "ui/scenes/overlay_scene.h"

#include "ui/scenes/frame_layer.h"
#include "ui/scenes/overlay_strokes.h"
#include "ui/scenes/stroke_actor.h"

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace ui {
namespace {

/// What one window shows of the scene; every window has its own OpenGL objects.
struct Layer {
    vtkNew<vtkRenderer> renderer;
    FrameQuad quad;
    StrokeActor strokes;
    std::pair<vtkWeakPointer<vtkRenderWindow>, unsigned long> watch;
    std::uint64_t shownRevision = 0;
    ViewRect shownRect;
    std::pair<int, int> shownSize{0, 0};
};

}   // namespace

struct OverlayScene::Parts {
    core::VesselTree tree;
    core::ProjectionCamera camera;
    core::RigidTransform cameraFromPatient;
    OverlayContent content;
    bool isProjectionStale = true;
    GreyFrame frame;
    Interpolation interpolation = Interpolation::Smooth;
    ViewRect viewRect{-0.5, 511.5, -0.5, 511.5};
    std::uint64_t revision = 1;
    std::vector<std::unique_ptr<Layer>> layers;

    void project()
    {
        if (std::exchange(isProjectionStale, false)) {
            content.tree =
                core::findProblem(camera).empty() ? projectedTree(tree, camera, cameraFromPatient) : ProjectedTree{};
        }
    }
    void markProjectionStale()
    {
        isProjectionStale = true;
        ++revision;
    }
    void update(Layer& layer);
};

void OverlayScene::Parts::update(Layer& layer)
{
    const int* size = layer.renderer->GetSize();
    const DeviceFromImage device{viewRect, std::max(1, size[0]), std::max(1, size[1])};
    layer.quad.show(frame, interpolation, device.scale());
    showImagePlane(*layer.renderer->GetActiveCamera(), viewRect);
    const std::pair shown{device.width, device.height};
    if (layer.shownRevision == revision && layer.shownRect == viewRect && layer.shownSize == shown) {
        return;
    }
    project();
    layer.strokes.show(overlayStrokes(content, device));
    layer.shownRevision = revision;
    layer.shownRect = viewRect;
    layer.shownSize = shown;
}

OverlayScene::OverlayScene() : parts_(std::make_unique<Parts>()) {}

OverlayScene::~OverlayScene()
{
    // The renderers stay with their windows, which free their OpenGL objects in the right context.
    for (const auto& layer : parts_->layers) {
        layer->renderer->RemoveObserver(layer->watch.second);
    }
}

void OverlayScene::setFrame(const core::ImageF& frame)
{
    parts_->frame.setPixels(frame);
}

void OverlayScene::setWindowLevel(double window, double level)
{
    parts_->frame.setRange({level - 0.5 * window, level + 0.5 * window});
}

void OverlayScene::setInverted(bool inverted)
{
    parts_->frame.setInverted(inverted);
}

void OverlayScene::setInterpolation(Interpolation interpolation)
{
    parts_->interpolation = interpolation;
}

void OverlayScene::setTree(const core::VesselTree& tree)
{
    parts_->tree = tree;
    parts_->markProjectionStale();
}

void OverlayScene::setCamera(const core::ProjectionCamera& camera)
{
    parts_->camera = camera;
    parts_->markProjectionStale();
}

void OverlayScene::setPose(const core::RigidTransform& cameraFromPatient)
{
    parts_->cameraFromPatient = cameraFromPatient;
    parts_->markProjectionStale();
}

void OverlayScene::setMarks(const BranchMarks& marks)
{
    if (!(parts_->content.marks == marks)) {
        parts_->content.marks = marks;
        ++parts_->revision;
    }
}

void OverlayScene::setMode(OverlayMode mode)
{
    parts_->content.mode = mode;
    ++parts_->revision;
}

void OverlayScene::setOpacity(double opacity)
{
    parts_->content.opacity = std::clamp(opacity, 0.0, 1.0);
    ++parts_->revision;
}

void OverlayScene::setLineWidthPx(double devicePixels)
{
    if (parts_->content.lineWidthPx != devicePixels) {
        parts_->content.lineWidthPx = devicePixels;
        ++parts_->revision;
    }
}

void OverlayScene::setTracedCenterline(const core::Centerline2d& traced)
{
    parts_->content.traced = traced;
    ++parts_->revision;
}

void OverlayScene::showTracedCenterline(bool shown)
{
    parts_->content.isTracedShown = shown;
    ++parts_->revision;
}

void OverlayScene::setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx)
{
    parts_->content.residualPx = residualPx;
    parts_->content.scaleMaximumPx = scaleMaximumPx;
    ++parts_->revision;
}

void OverlayScene::clearResiduals()
{
    setResiduals({}, 0.0);
}

void OverlayScene::setViewRect(const ViewRect& rect)
{
    parts_->viewRect = rect;
}

const core::ImageF& OverlayScene::frame() const
{
    return parts_->frame.pixels();
}

ViewRect OverlayScene::viewRect() const
{
    return parts_->viewRect;
}

double OverlayScene::lineWidthPx() const
{
    return parts_->content.lineWidthPx;
}

void OverlayScene::attachTo(vtkRenderWindow* window)
{
    auto layer = std::make_unique<Layer>();
    const auto canvas = palette(ThemeMode::Dark).canvas.unit();
    layer->renderer->SetBackground(canvas[0], canvas[1], canvas[2]);
    layer->renderer->InteractiveOff();
    layer->renderer->AddActor(layer->quad.actor());
    layer->renderer->AddActor2D(layer->strokes.actor());
    vtkNew<vtkCallbackCommand> refresh;
    struct Client {
        Parts* parts;
        Layer* layer;
    };
    refresh->SetClientData(new Client{parts_.get(), layer.get()});
    refresh->SetClientDataDeleteCallback([](void* client) { delete static_cast<Client*>(client); });
    refresh->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
        const auto* c = static_cast<Client*>(client);
        c->parts->update(*c->layer);
    });
    layer->watch = {window, layer->renderer->AddObserver(vtkCommand::StartEvent, refresh)};
    window->AddRenderer(layer->renderer);
    parts_->layers.push_back(std::move(layer));
}

void OverlayScene::detachFrom(vtkRenderWindow* window)
{
    std::erase_if(parts_->layers, [window](const std::unique_ptr<Layer>& layer) {
        if (layer->watch.first.GetPointer() != window) {
            return false;
        }
        layer->renderer->RemoveObserver(layer->watch.second);
        window->RemoveRenderer(layer->renderer);
        return true;
    });
}

std::optional<int> OverlayScene::branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const
{
    if (parts_->content.mode == OverlayMode::Hidden) {
        return std::nullopt;
    }
    parts_->project();
    return nearestBranch(parts_->content.tree, imagePoint, tolerancePx);
}

bool OverlayScene::treePasses(const ViewRect& part) const
{
    parts_->project();
    return parts_->content.mode != OverlayMode::Hidden && passesThrough(parts_->content.tree, part);
}

}   // namespace ui
