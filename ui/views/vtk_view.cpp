#include "ui/views/vtk_view.h"

#include "ui/scenes/gl_window.h"
#include "ui/views/offscreen_context.h"

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#include <QElapsedTimer>
#include <QPainter>

#include <chrono>

namespace ui {
namespace {

using namespace std::chrono_literals;

constexpr int settledSamples = 4;
constexpr int frameMs = 16;

}   // namespace

struct VtkView::Glue {
    OffscreenContext context;
    vtkNew<GlWindow> window;
    enum class State { Untried, Ready, Missing } state = State::Untried;
    int lastRenderMs = 0;

    void observe(unsigned long event, void (*reaction)(vtkObject*, unsigned long, void*, void*))
    {
        vtkNew<vtkCallbackCommand> command;
        command->SetCallback(reaction);
        command->SetClientData(&context);
        window->AddObserver(event, command);
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
            render(Quality::Draft);
            update();
        }
    });
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(250ms);
    connect(&settleTimer_, &QTimer::timeout, this, [this] {
        if (isVisible()) {
            render(Quality::Settled);
            update();
        }
    });
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
    // Never more than half of the time goes into this view, however slow the computer: input and angiogram come first.
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

void VtkView::render(Quality quality)
{
    renderTimer_.stop();
    if (!prepareContext()) {
        return;
    }
    QElapsedTimer timer;
    timer.start();
    const QSize device = deviceSize();
    glue_->window->SetSize(device.width(), device.height());
    glue_->window->SetMultiSamples(quality == Quality::Settled ? settledSamples : 0);
    prepareFrame();
    glue_->window->takeOverState();
    glue_->window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    glue_->window->GetPixelData(0, 0, device.width() - 1, device.height() - 1, 1, pixels, 0);
    glue_->context.doneCurrent();
    picture_ = QImage(pixels->GetPointer(0), device.width(), device.height(), qsizetype{3} * device.width(),
                      QImage::Format_RGB888)
                   .mirrored()   // OpenGL counts rows from the bottom
                   .convertToFormat(QImage::Format_RGB32);
    ++renderCount_;
    if (quality == Quality::Draft) {
        glue_->lastRenderMs = static_cast<int>(timer.elapsed());
        settleTimer_.start();
    }
}

void VtkView::paintEvent(QPaintEvent*)
{
    if (picture_.isNull()) {
        render(Quality::Draft);
    }
    QPainter painter(this);
    if (picture_.isNull()) {
        paintExcuse(painter);
        return;
    }
    if (picture_.size() == deviceSize()) {
        picture_.setDevicePixelRatio(devicePixelRatio());
        painter.drawImage(QPointF(0.0, 0.0), picture_);
    } else {   // for a moment: the window's repaint does not wait for VTK
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
                     tr("The 3-D view needs OpenGL 3.2, which this display does not offer. Everything else works. "
                        "Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri."));
}

void VtkView::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    requestRender();
}

}   // namespace ui
