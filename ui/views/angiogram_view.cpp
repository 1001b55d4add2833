#include "ui/views/angiogram_view.h"

#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_interaction.h"

#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {
namespace {

/// Faint stripes where the mask is 0.
QImage hatched(const core::Mask2d& fieldMask)
{
    constexpr int period = 8;
    QImage image(fieldMask.width, fieldMask.height, QImage::Format_ARGB32_Premultiplied);
    const QRgb stripe = qPremultiply(toQColor(palette(ThemeMode::Dark).attention, 0.30).rgba());
    const QRgb between = qPremultiply(toQColor(palette(ThemeMode::Dark).attention, 0.07).rgba());
    for (int y = 0; y < fieldMask.height; ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < fieldMask.width; ++x) {
            row[x] = fieldMask.at(x, y) != 0 ? 0U : (x + y) % period < 2 ? stripe : between;
        }
    }
    return image;
}

}   // namespace

ToolPoint AngiogramView::Interaction::toolPoint(const QPointF& position, Qt::KeyboardModifiers modifiers) const
{
    return {position, viewport.imageFromWidget({position.x(), position.y()}), modifiers};
}

double AngiogramView::Interaction::mmPerImagePx() const
{
    const double depth = (cameraFromPatient * pivotInPatient).z();
    const bool isKnown = core::findProblem(camera).empty() && depth >= core::minProjectableDepthMm;
    return isKnown ? core::millimetresPerPixel(camera, depth) : 0.0;
}

AngiogramView::AngiogramView(QWidget* parent) : QWidget(parent), interaction_(std::make_unique<Interaction>())
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Angiogram with the projected vessel tree"));
}

AngiogramView::~AngiogramView() = default;

void AngiogramView::setPivot(const Eigen::Vector3d& pivotInPatient)
{
    interaction_->pivotInPatient = pivotInPatient;
    update();
}

void AngiogramView::setPose(const core::RigidTransform& cameraFromPatient)
{
    interaction_->cameraFromPatient = cameraFromPatient;
    scene_.setPose(cameraFromPatient);
    update();
}

void AngiogramView::setCamera(const core::ProjectionCamera& camera)
{
    interaction_->camera = camera;
    scene_.setCamera(camera);
    update();
}

void AngiogramView::setFrame(const core::ImageF& frame)
{
    Interaction& i = *interaction_;
    const std::pair size{frame.width, frame.height};
    const bool isNew = !i.hasFrame || size != i.frameSize;
    i.frameSize = size;
    i.hasFrame = !frame.isEmpty();
    scene_.setFrame(frame);
    if (isNew && i.hasFrame) {
        i.viewport.setImageSize(frame.width, frame.height);
        fitToWindow();
        autoWindowLevel();
    }
    update();
}

void AngiogramView::setFramePosition(int index, int count)
{
    interaction_->annotations.frameText = count > 1 ? tr("frame %1 of 0–%2").arg(index).arg(count - 1) : QString();
    update();
}

void AngiogramView::setCornerTexts(const CornerTexts& texts)
{
    interaction_->annotations.texts = texts;
    update();
}

void AngiogramView::setTool(ImageTool* tool)
{
    Interaction& i = *interaction_;
    if (tool == i.tool) {
        return;
    }
    cancelDrag();
    if (ImageTool* former = std::exchange(i.tool, nullptr)) {
        former->end();
    }
    i.tool = tool;
    scene_.setVeiled(tool && tool->hidesOverlay());
    hover(std::nullopt);
    if (tool) {
        tool->begin();
    }
    showCursor();
    update();
    emit toolChanged();
}

ImageTool* AngiogramView::tool() const
{
    return interaction_->tool;
}

void AngiogramView::setKeptOut(const core::Mask2d& fieldMask)
{
    interaction_->keptOut = fieldMask.isEmpty() ? QImage() : hatched(fieldMask);
    update();
}

void AngiogramView::setResidualScale(double maximumPx, double maximumMm)
{
    interaction_->annotations.scaleMaximumPx = maximumPx;
    interaction_->annotations.scaleMaximumMm = maximumMm;
    update();
}

void AngiogramView::setLineWidth(double px)
{
    interaction_->lineWidth = px;
    update();
}

void AngiogramView::setCutout(Cutout::Shape shape)
{
    cutout_ = shape;
    const QPointF mouse = mapFromGlobal(QCursor::pos());
    placeCutout(rect().contains(mouse.toPoint()) ? mouse : QRectF(rect()).center());
}

void AngiogramView::placeCutout(const QPointF& position)
{
    constexpr double lensRadius = 70.0;
    scene_.setCutout({cutout_, imageFromWidget(position), lensRadius / zoom()});
    update();
}

void AngiogramView::setOrientationKnown(bool known)
{
    interaction_->isOrientationKnown = known;
    update();
}

void AngiogramView::setFromSource(bool fromSource)
{
    interaction_->viewport.setMirrored(fromSource);
    update();
}

bool AngiogramView::isFromSource() const
{
    return interaction_->viewport.isMirrored();
}

QString AngiogramView::sideMark() const
{
    const bool isMirroredImage = interaction_->camera.fx > 0.0;
    if (isFromSource()) {
        return isMirroredImage ? tr("Mirrored image, mirrored back by the view")
                               : tr("Seen from the source: the view is mirrored");
    }
    return isMirroredImage ? tr("Mirrored image: as seen from the source") : QString();
}

void AngiogramView::zoomTo(const ViewRect& part)
{
    const double margin = 0.25 * std::max({part.width(), part.height(), 40.0});
    showPart({part.left - margin, part.right + margin, part.top - margin, part.bottom + margin});
}

void AngiogramView::showPart(const ViewRect& part)
{
    interaction_->viewport.show(part);
    emit zoomChanged(zoom());
    update();
}

void AngiogramView::fitToWindow()
{
    interaction_->viewport.fit();
    emit zoomChanged(zoom());
    update();
}

void AngiogramView::autoWindowLevel()
{
    const core::DisplayRange range = core::displayRange(scene_.frame());
    setWindowLevel(range.window(), range.level());
}

void AngiogramView::setWindowLevel(double window, double level)
{
    interaction_->annotations.range = {level - 0.5 * window, level + 0.5 * window};
    scene_.setWindowLevel(window, level);
    emit windowLevelChanged(window, level);
    update();
}

core::DisplayRange AngiogramView::shownRange() const
{
    return interaction_->annotations.range;
}

ViewRect AngiogramView::visiblePart() const
{
    return interaction_->viewport.rect();
}

bool AngiogramView::isFitted() const
{
    return interaction_->viewport.isFitted();
}

double AngiogramView::zoom() const
{
    return interaction_->viewport.zoom();
}

const core::ProjectionCamera& AngiogramView::camera() const
{
    return interaction_->camera;
}

const core::RigidTransform& AngiogramView::cameraFromPatient() const
{
    return interaction_->cameraFromPatient;
}

const Eigen::Vector3d& AngiogramView::pivotInPatient() const
{
    return interaction_->pivotInPatient;
}

void AngiogramView::addBar(QWidget* bar)
{
    auto* bars = qobject_cast<QVBoxLayout*>(layout());
    if (!bars) {
        bars = new QVBoxLayout(this);
        bars->setSizeConstraint(QLayout::SetNoConstraint);
        bars->setContentsMargins(0, 0, 0, 14);
        bars->addStretch(1);
    }
    bar->setAttribute(Qt::WA_NoMousePropagation);
    bars->addWidget(bar, 0, Qt::AlignHCenter);
}

Eigen::Vector2d AngiogramView::imageFromWidget(const QPointF& position) const
{
    return interaction_->viewport.imageFromWidget({position.x(), position.y()});
}

QPointF AngiogramView::widgetFromImage(const Eigen::Vector2d& imagePoint) const
{
    const Eigen::Vector2d position = interaction_->viewport.widgetFromImage(imagePoint);
    return {position.x(), position.y()};
}

QSize AngiogramView::deviceSize() const
{
    return (size() * devicePixelRatio()).expandedTo({1, 1});
}

void AngiogramView::drawPicture()
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
    // At fractional scale factors the picture is a whole number of pixels, not exactly size × ratio.
    scene_.setViewRect(
        interaction_->viewport.imageRectOf({0.0, 0.0}, {device.width() / ratio, device.height() / ratio}));
    const std::optional<PictureState> wanted =
        interaction_->tool ? std::nullopt : std::optional(PictureState{scene_.stamp(), isFromSource()});
    if (wanted && wanted == drawn_ && !isNew) {
        return;   // only what lies over it changed
    }
    drawn_ = wanted;
    scene_.draw(canvas);
    if (isFromSource()) {
        for (int row = 0; row < canvas.height; ++row) {
            std::reverse(canvas.row(row), canvas.row(row) + canvas.width);
        }
    }
    if (interaction_->tool) {
        interaction_->tool->drawStrokes(canvas);
    }
}

void AngiogramView::paintEvent(QPaintEvent*)
{
    drawPicture();
    ++renderCount_;
    QPainter painter(this);
    painter.drawImage(QPointF(0.0, 0.0), picture_);
    if (!interaction_->hasFrame) {
        return;
    }
    if (!interaction_->keptOut.isNull()) {
        const QPointF topLeft = widgetFromImage({-0.5, -0.5});
        const QSizeF covered = QSizeF(interaction_->keptOut.size()) * zoom();
        painter.drawImage(QRectF(topLeft, covered), interaction_->keptOut);
    }
    interaction_->annotations.mmPerImagePx = interaction_->mmPerImagePx();
    interaction_->annotations.sides = interaction_->isOrientationKnown
                                          ? imageSides(interaction_->camera, interaction_->cameraFromPatient)
                                          : ImageSides{};
    interaction_->annotations.sideMark = sideMark();
    if (isFromSource()) {
        std::swap(interaction_->annotations.sides.left, interaction_->annotations.sides.right);
    }
    painter.setFont(font());
    interaction_->annotations.mode =
        interaction_->tool ? ModeLabel{interaction_->tool->caption(), interaction_->tool->tone()} : ModeLabel{};
    ui::paintAnnotations(painter, size(), interaction_->annotations, interaction_->viewport, scene_);
    if (interaction_->tool) {
        painter.setRenderHint(QPainter::Antialiasing);
        interaction_->tool->paint(painter);
    }
}

}   // namespace ui
