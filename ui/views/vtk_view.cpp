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

/// Subpixel offsets, in px, of the renderings averaged at rest: one per quarter of a pixel, on four rows and columns.
const std::array<QPointF, 4> settledShiftsPx{{{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}}};

/// Replaces `image` by the mean of two images of the same size.
void blendInto(QImage& picture, const QImage& other)
{
    std::uint8_t* bytes = picture.bits();
    std::transform(bytes, bytes + picture.sizeInBytes(), other.constBits(), bytes,
                   [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a + b + 1) / 2); });
}

void movePicture(vtkRenderWindow& window, const QPointF& shiftPx)
{
    const int* size = window.GetSize();
    vtkRendererCollection* renderers = window.GetRenderers();
    for (int i = 0; i < renderers->GetNumberOfItems(); ++i) {
        auto* renderer = static_cast<vtkRenderer*>(renderers->GetItemAsObject(i));
        renderer->GetActiveCamera()->SetWindowCenter(2.0 * shiftPx.x() / size[0], 2.0 * shiftPx.y() / size[1]);
    }
}

}   // namespace

struct VtkView::Glue {
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
            window->letGoOfOldBuffers();
            context.doneCurrent();
        }
    }
};

VtkView::VtkView(QWidget* parent) : QWidget(parent), glue_(std::make_unique<Glue>())
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);
    setAttribute(Qt::WA_OpaquePaintEvent);
    glue_->observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* client, void*) {
        static_cast<OffscreenContext*>(client)->makeCurrent();
    });
    glue_->observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* client, void* answer) {
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
    if (glue_->state == Glue::State::Ready) {
        glue_->context.makeCurrent();
        glue_->window->Finalize();
        glue_->context.doneCurrent();
    }
    glue_->window->RemoveAllObservers();
}

vtkRenderWindow* VtkView::renderWindow() const
{
    return glue_->window;
}

QSize VtkView::deviceSize() const
{
    return (size() * devicePixelRatio()).expandedTo({1, 1});
}

void VtkView::requestRender()
{
    // On slow computers, limits this view to half of the time, in favor of input and the angiogram.
    if (!renderTimer_.isActive()) {
        renderTimer_.start(glue_->lastRenderMs > frameMs ? glue_->lastRenderMs : 0);
    }
}

void VtkView::paintAnnotations(QPainter&) {}

bool VtkView::prepareContext()
{
    if (glue_->state == Glue::State::Untried) {
        const bool isThere = glue_->context.create() && glue_->context.makeCurrent();
        glue_->state = isThere ? Glue::State::Ready : Glue::State::Missing;
        if (isThere) {
            glue_->window->takeOverState();
            glue_->window->SetReadyForRendering(true);
            glue_->window->OpenGLInitContext();
        }
    }
    return glue_->state == Glue::State::Ready && glue_->context.makeCurrent();
}

void VtkView::rehearse()
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
    picture_ = drawn({});
    ++renderCount_;
    glue_->lastRenderMs = static_cast<int>(timer.elapsed());
    passes_.clear();
    settleTimer_.start(250ms);
}

/// Renders the next of the offset passes; after the last one, shows the mean of all passes.
void VtkView::settle()
{
    if (!isVisible() || renderTimer_.isActive() || picture_.size() != deviceSize() || !prepareContext()) {
        passes_.clear();   // discards the passes; the next rendering starts over
        return;
    }
    passes_.push_back(drawn(settledShiftsPx[passes_.size()]));
    if (passes_.size() % 2 == 0) {
        blendInto(passes_[passes_.size() - 2], passes_.back());
    }
    if (passes_.size() < settledShiftsPx.size()) {
        settleTimer_.start(0ms);
        return;
    }
    glue_->letGoOfLargerBuffers();
    blendInto(passes_[0], passes_[2]);
    picture_ = passes_[0];
    passes_.clear();
    ++renderCount_;
    update();
}

QImage VtkView::drawn(const QPointF& shiftPx)
{
    const QSize device = deviceSize();
    glue_->window->SetSize(device.width(), device.height());
    glue_->largestPx = std::max(glue_->largestPx, glue_->sizePx());
    prepareFrame();
    movePicture(*glue_->window, shiftPx);
    glue_->window->takeOverState();
    glue_->window->Render();
    QImage picture(device, QImage::Format_RGB32);
    glue_->window->readPicture({reinterpret_cast<std::uint32_t*>(picture.bits()), device.width(), device.height()});
    movePicture(*glue_->window, {});
    glue_->context.doneCurrent();
    return picture;
}

void VtkView::paintEvent(QPaintEvent*)
{
    if (picture_.isNull()) {
        drawDraft();
    }
    QPainter painter(this);
    if (picture_.isNull()) {
        paintExcuse(painter);
        return;
    }
    if (picture_.size() == deviceSize()) {
        picture_.setDevicePixelRatio(devicePixelRatio());
        painter.drawImage(QPointF(0.0, 0.0), picture_);
    } else {   // shows the last image scaled, since repainting does not wait for VTK
        painter.drawImage(rect(), picture_);
        requestRender();
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintAnnotations(painter);
}

void VtkView::paintExcuse(QPainter& painter)
{
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The 3-D view needs OpenGL 3.2, which this display does not support. Everything else works. "
                        "Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri."));
}

void VtkView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    requestRender();
}

}   // namespace angiopose::ui
