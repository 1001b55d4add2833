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
        whole_ = {};   // discards the outdated image
        return;
    }
    isRedrawDue_ = true;
    if (!turnTimer_.isActive()) {
        turnTimer_.start(0);
    }
}

/// Completes an update in progress first; otherwise continuous mouse movement would block all updates.
void AngiogramView::takeTurn()
{
    if (nextTurn_ == Turn::Picture) {
        isRedrawDue_ = false;
        if (drawPicture()) {
            nextTurn_ = Turn::Whole;
            turnTimer_.start(0);
            return;
        }
    }
    nextTurn_ = Turn::Picture;
    drawWhole();
    update();
    if (isRedrawDue_) {
        turnTimer_.start(0);
    }
}

/// Draws the angiogram with the tree; returns false if the image is already up to date.
bool AngiogramView::drawPicture()
{
    const double ratio = devicePixelRatio();
    const QSize device = deviceSize();
    const bool isNew = picture_.size() != device;
    if (isNew) {
        picture_ = QImage(device, QImage::Format_RGB32);
    }
    picture_.setDevicePixelRatio(ratio);
    const Canvas canvas{reinterpret_cast<std::uint32_t*>(picture_.bits()), device.width(), device.height()};
    scene_.setLineWidthPx(interaction_->lineWidth * ratio);
    // At fractional scale factors, the image size is rounded to whole device px and differs from size × ratio.
    scene_.setViewRect(
        interaction_->viewport.imageRectOf({0.0, 0.0}, {device.width() / ratio, device.height() / ratio}));
    const std::optional<PictureState> wanted =
        interaction_->tool ? std::nullopt : std::optional(PictureState{scene_.stamp(), isFromSource()});
    if (wanted && wanted == drawn_ && !isNew) {
        return false;   // only annotations may have changed
    }
    drawn_ = wanted;
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
    forBands(canvas.height, [&](const Rows& rows) { fillStrokes(above, canvas.height, canvas, rows); });
}

void AngiogramView::strokeMarks()
{
    const auto placeOf = [this](const Eigen::Vector2d& pixel) { return interaction_->viewport.widgetFromImage(pixel); };
    const Canvas canvas{reinterpret_cast<std::uint32_t*>(whole_.bits()), whole_.width(), whole_.height()};
    const MarkPicture picture{{1.0 * canvas.width, 1.0 * canvas.height}, whole_.devicePixelRatio()};
    const Palette& tones = annotationTones();
    const StrokeMesh strokes = markStrokes(seenMarks(), placeOf, picture, tones, tones.canvas);
    fillStrokes(strokes, canvas.height, canvas);
}

/// Copies the rendering and draws all annotations over the copy.
void AngiogramView::drawWhole()
{
    ++renderCount_;
    if (whole_.size() != picture_.size()) {
        whole_ = QImage(picture_.size(), picture_.format());
    }
    whole_.setDevicePixelRatio(picture_.devicePixelRatio());
    barsInWhole_ = barPlaces();
    std::copy_n(picture_.constBits(), picture_.sizeInBytes(), whole_.bits());
    strokeMarks();
    QPainter painter(&whole_);
    painter.setFont(font());
    if (interaction_->hasFrame) {
        paintOver(painter);
    } else {
        paintAbsence(painter);
    }
}

/// Copies the last rendering; grabbing the widget renders immediately instead of waiting for the event loop.
void AngiogramView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const bool isOnScreen = backingStore() && painter.paintEngine()->paintDevice() == backingStore()->paintDevice();
    if (!isOnScreen) {
        (void)drawPicture();
        drawWhole();
    } else if (whole_.size() != deviceSize() || barsInWhole_ != barPlaces()) {
        redraw();
    }
    if (whole_.isNull()) {
        painter.fillRect(rect(), toQColor(ui::palette(ThemeMode::Dark).canvas));
    } else {
        painter.drawImage(
            whole_.size() == deviceSize() ? QRectF(QPointF(0.0, 0.0), whole_.deviceIndependentSize()) : QRectF(rect()),
            whole_);
    }
}

}   // namespace angiopose::ui
