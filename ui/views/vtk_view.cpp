#include "ui/views/vtk_view.h"

#include "ui/scenes/gl_window.h"
#include "ui/views/offscreen_context.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <QElapsedTimer>
#include <QPainter>

#include <algorithm>
#include <array>
#include <chrono>

namespace angiopose::ui {
namespace {

using namespace std::chrono_literals;

constexpr int frameMs = 16;

/// Subpixel offsets, in px, of renderings averaged at rest: one in each quarter of a pixel, on four rows and columns.
const std::array<QPointF, 4> sampleOffsetsPx{{{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}}};

/// Replaces `image` by the mean of two images of the same size.
void blendInto(QImage& image, const QImage& other)
{
    std::uint8_t* bytes = image.bits();
    std::transform(bytes, bytes + image.sizeInBytes(), other.constBits(), bytes,
                   [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a + b + 1) / 2); });
}

void shiftImage(vtkRenderWindow& window, const QPointF& shiftPx)
{
    const int* size = window.GetSize();
    vtkRendererCollection* renderers = window.GetRenderers();
    for (int i = 0; i < renderers->GetNumberOfItems(); ++i) {
        auto* renderer = static_cast<vtkRenderer*>(renderers->GetItemAsObject(i));
        renderer->GetActiveCamera()->SetWindowCenter(2.0 * shiftPx.x() / size[0], 2.0 * shiftPx.y() / size[1]);
    }
}

}   // namespace

struct VtkView::VtkResources {
    OffscreenContext context;
    vtkNew<GlWindow> window;
    enum class State { Untried, Ready, Missing } state = State::Untried;
    int lastRenderMs = 0;
    qint64 largestPx = 0;   // px of the largest rendering so far, whose buffers OpenGL may still hold

    void observe(unsigned long event, void (*reaction)(vtkObject*, unsigned long, void*, void*))
    {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(reaction);
        command->SetClientData(&context);
        window->AddObserver(event, command);
    }

    qint64 sizePx() const
    {
        const int* size = window->GetSize();
        return qint64{size[0]} * size[1];
    }

    void letGoOfLargerBuffers()
    {
        if (largestPx > sizePx() && context.makeCurrent()) {
            window->releaseOldBuffers();
            context.doneCurrent();
        }
    }
};

VtkView::VtkView(QWidget* parent) : QWidget(parent), vtk_(std::make_unique<VtkResources>())
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);
    setAttribute(Qt::WA_OpaquePaintEvent);
    vtk_->observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* client, void*) {
        static_cast<OffscreenContext*>(client)->makeCurrent();
    });
    vtk_->observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* client, void* answer) {
        *static_cast<bool*>(answer) = static_cast<OffscreenContext*>(client)->isCurrent();
    });
    renderTimer_.setSingleShot(true);
    connect(&renderTimer_, &QTimer::timeout, this, [this] {
        if (isVisible()) {
            drawDraft();
            update();
        }
    });
    settleTimer_.setSingleShot(true);
    connect(&settleTimer_, &QTimer::timeout, this, &VtkView::settle);
}

VtkView::~VtkView()
{
    if (vtk_->state == VtkResources::State::Ready) {
        vtk_->context.makeCurrent();
        vtk_->window->Finalize();
        vtk_->context.doneCurrent();
    }
    vtk_->window->RemoveAllObservers();
}

vtkRenderWindow* VtkView::renderWindow() const
{
    return vtk_->window;
}

QSize VtkView::deviceSize() const
{
    return (size() * devicePixelRatio()).expandedTo({1, 1});
}

void VtkView::requestRender()
{
    // On slow computers, limit this view to half of the time, in favor of input and the angiogram.
    if (!renderTimer_.isActive()) {
        renderTimer_.start(vtk_->lastRenderMs > frameMs ? vtk_->lastRenderMs : 0);
    }
}

void VtkView::paintAnnotations(QPainter&) {}

bool VtkView::prepareContext()
{
    if (vtk_->state == VtkResources::State::Untried) {
        const bool isReady = vtk_->context.create() && vtk_->context.makeCurrent();
        vtk_->state = isReady ? VtkResources::State::Ready : VtkResources::State::Missing;
        if (isReady) {
            vtk_->window->resetState();
            vtk_->window->SetReadyForRendering(true);
            vtk_->window->OpenGLInitContext();
        }
    }
    return vtk_->state == VtkResources::State::Ready && vtk_->context.makeCurrent();
}

void VtkView::renderHidden()
{
    if (prepareContext()) {
        (void)drawn({});
    }
}

void VtkView::drawDraft()
{
    renderTimer_.stop();
    if (!prepareContext()) {
        return;
    }
    QElapsedTimer timer;
    timer.start();
    image_ = drawn({});
    ++renderCount_;
    vtk_->lastRenderMs = static_cast<int>(timer.elapsed());
    samples_.clear();
    settleTimer_.start(250ms);
}

/// Renders the next pass with an offset; after the last one, shows the mean of all passes.
void VtkView::settle()
{
    if (!isVisible() || renderTimer_.isActive() || image_.size() != deviceSize() || !prepareContext()) {
        samples_.clear();   // discards the passes, so that the next rendering starts over
        return;
    }
    samples_.push_back(drawn(sampleOffsetsPx[samples_.size()]));
    if (samples_.size() % 2 == 0) {
        blendInto(samples_[samples_.size() - 2], samples_.back());
    }
    if (samples_.size() < sampleOffsetsPx.size()) {
        settleTimer_.start(0ms);
        return;
    }
    vtk_->letGoOfLargerBuffers();
    blendInto(samples_[0], samples_[2]);
    image_ = samples_[0];
    samples_.clear();
    ++renderCount_;
    update();
}

QImage VtkView::drawn(const QPointF& shiftPx)
{
    const QSize device = deviceSize();
    vtk_->window->SetSize(device.width(), device.height());
    vtk_->largestPx = std::max(vtk_->largestPx, vtk_->sizePx());
    prepareFrame();
    shiftImage(*vtk_->window, shiftPx);
    vtk_->window->resetState();
    vtk_->window->Render();
    QImage image(device, QImage::Format_RGB32);
    vtk_->window->readPixels({reinterpret_cast<std::uint32_t*>(image.bits()), device.width(), device.height()});
    shiftImage(*vtk_->window, {});
    vtk_->context.doneCurrent();
    return image;
}

void VtkView::paintEvent(QPaintEvent*)
{
    if (image_.isNull()) {
        drawDraft();
    }
    QPainter painter(this);
    if (image_.isNull()) {
        paintError(painter);
        return;
    }
    if (image_.size() == deviceSize()) {
        image_.setDevicePixelRatio(devicePixelRatio());
        painter.drawImage(QPointF(0.0, 0.0), image_);
    } else {   // shows the last image scaled, since repainting does not wait for VTK
        painter.drawImage(rect(), image_);
        requestRender();
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintAnnotations(painter);
}

void VtkView::paintError(QPainter& painter)
{
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The 3-D view requires OpenGL 3.2, which this display does not support. Everything else works. "
                        "Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri."));
}

void VtkView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    requestRender();
}

}   // namespace angiopose::ui
