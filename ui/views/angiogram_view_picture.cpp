// Rendering of AngiogramView, drawn in two turns of the event loop and then copied by paintEvent.
#include "ui/scenes/fill_strokes.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_interaction.h"
#include "ui/views/gl_driver.h"
#include "ui/views/gl_overlay.h"
#include "ui/views/mark_strokes.h"
#include "ui/views/shadowed_text.h"

#include <QBackingStore>
#include <QPaintEngine>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace angiopose::ui {

QSize AngiogramView::deviceSize() const
{
    return (size() * devicePixelRatio()).expandedTo({1, 1});
}

void AngiogramView::redraw()
{
    if (!isVisible()) {
        annotated_ = {};   // discards the outdated image
        return;
    }
    isRedrawDue_ = true;
    if (!drawTimer_.isActive()) {
        drawTimer_.start(0);
    }
}

/// Completes an update in progress first; otherwise, continuous mouse movement would block all updates.
void AngiogramView::drawNext()
{
    if (nextStep_ == DrawStep::Image) {
        isRedrawDue_ = false;
        if (renderImage()) {
            nextStep_ = DrawStep::Annotated;
            drawTimer_.start(0);
            return;
        }
    }
    nextStep_ = DrawStep::Image;
    drawAnnotated();
    update();
    if (isRedrawDue_) {
        drawTimer_.start(0);
    }
}

/// Draws the angiogram with the tree; returns false if the image is already up to date.
bool AngiogramView::renderImage()
{
    const double ratio = devicePixelRatio();
    const QSize device = deviceSize();
    const bool isNew = image_.size() != device;
    if (isNew) {
        image_ = QImage(device, QImage::Format_RGB32);
    }
    image_.setDevicePixelRatio(ratio);
    const Canvas canvas{reinterpret_cast<std::uint32_t*>(image_.bits()), device.width(), device.height()};
    scene_.setLineWidthPx(interaction_->lineWidth * ratio);
    // At fractional scale factors, the image size is rounded to whole device px and differs from size × ratio.
    scene_.setViewRect(
        interaction_->viewport.imageRectOf({0.0, 0.0}, {device.width() / ratio, device.height() / ratio}));
    const std::optional<ImageState> requested =
        interaction_->tool ? std::nullopt : std::optional(ImageState{scene_.stamp(), isFromSource()});
    if (requested && requested == drawnState_ && !isNew) {
        return false;   // only annotations may have changed
    }
    drawnState_ = requested;
    render(canvas, interaction_->tool ? interaction_->tool->strokes(canvas.height) : StrokeMesh{});
    return true;
}

void AngiogramView::render(Canvas canvas, const StrokeMesh& above)
{
    if (!std::exchange(isRendererKnown_, true) && chosenRenderer() == Renderer::Vtk) {
        gl_ = std::make_unique<GlOverlay>();
    }
    if (gl_ && gl_->isReady()) {
        gl_->draw(scene_, isFromSource(), above, canvas);
        return;
    }
    painter_.draw(scene_, canvas);
    if (isFromSource()) {
        for (int row = 0; row < canvas.height; ++row) {
            std::reverse(canvas.row(row), canvas.row(row) + canvas.width);
        }
    }
    forEachBand(canvas.height, [&](const Rows& rows) { fillStrokes(above, canvas.height, canvas, rows); });
}

void AngiogramView::strokeMarks()
{
    const auto positionOf = [this](const Eigen::Vector2d& pixel) {
        return interaction_->viewport.widgetFromImage(pixel);
    };
    const Canvas canvas{reinterpret_cast<std::uint32_t*>(annotated_.bits()), annotated_.width(), annotated_.height()};
    const MarkCanvas picture{{1.0 * canvas.width, 1.0 * canvas.height}, annotated_.devicePixelRatio()};
    const Palette& colors = annotationTones();
    const StrokeMesh strokes = markStrokes(visibleMarks(), positionOf, picture, colors, colors.canvas);
    fillStrokes(strokes, canvas.height, canvas);
}

/// Copies the rendering and draws all annotations over the copy.
void AngiogramView::drawAnnotated()
{
    ++renderCount_;
    if (annotated_.size() != image_.size()) {
        annotated_ = QImage(image_.size(), image_.format());
    }
    annotated_.setDevicePixelRatio(image_.devicePixelRatio());
    annotatedBars_ = barRects();
    std::copy_n(image_.constBits(), image_.sizeInBytes(), annotated_.bits());
    strokeMarks();
    QPainter painter(&annotated_);
    painter.setFont(font());
    if (interaction_->hasFrame) {
        paintOver(painter);
    } else {
        paintPlaceholder(painter);
    }
}

/// Copies the last rendering; grabbing the widget renders immediately instead of waiting for the event loop.
void AngiogramView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const bool isOnScreen = backingStore() && painter.paintEngine()->paintDevice() == backingStore()->paintDevice();
    if (!isOnScreen) {
        (void)renderImage();
        drawAnnotated();
    } else if (annotated_.size() != deviceSize() || annotatedBars_ != barRects()) {
        redraw();
    }
    if (annotated_.isNull()) {
        painter.fillRect(rect(), toQColor(ui::palette(ThemeMode::Dark).canvas));
    } else {
        painter.drawImage(annotated_.size() == deviceSize()
                              ? QRectF(QPointF(0.0, 0.0), annotated_.deviceIndependentSize())
                              : QRectF(rect()),
                          annotated_);
    }
}

}   // namespace angiopose::ui
