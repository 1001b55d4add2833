#include "ui/views/angiogram_view.h"

#include "ui/views/angiogram_interaction.h"
#include "ui/views/gl_overlay.h"
#include "ui/words/retranslation.h"

#include <algorithm>
#include <utility>

namespace angiopose::ui {
ToolPoint AngiogramView::Interaction::toolPoint(const QPointF& position, Qt::KeyboardModifiers modifiers) const
{
    return {position, viewport.imageFromWidget({position.x(), position.y()}), modifiers};
}

double AngiogramView::Interaction::mmPerImagePx() const
{
    const double depth = (cameraFromPatient * pivotInPatient).z();
    const bool isKnown = !core::findProblem(camera) && depth >= core::minProjectableDepthMm;
    return isKnown ? core::millimetersPerPixel(camera, depth) : 0.0;
}

AngiogramView::AngiogramView(ImageRole role, QWidget* parent)
    : QWidget(parent), interaction_(std::make_unique<Interaction>())
{
    interaction_->role = role;
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(80, 80);
    setAttribute(Qt::WA_OpaquePaintEvent);
    drawTimer_.setSingleShot(true);
    connect(&drawTimer_, &QTimer::timeout, this, &AngiogramView::drawNext);
    keepTranslated(this, [this] {
        setAccessibleName(tr("Angiogram with the projected vessel tree"));
        redraw();
    });
}

AngiogramView::~AngiogramView() = default;

void AngiogramView::setPivot(const Eigen::Vector3d& pivotInPatient)
{
    interaction_->pivotInPatient = pivotInPatient;
    redraw();
}

void AngiogramView::setPickedPivot(const std::optional<Eigen::Vector3d>& pickedInPatient)
{
    if (pickedInPatient != interaction_->pickedPivot) {
        interaction_->pickedPivot = pickedInPatient;
        redraw();
    }
}

void AngiogramView::setPose(const core::RigidTransform& cameraFromPatient)
{
    interaction_->cameraFromPatient = cameraFromPatient;
    scene_.setPose(cameraFromPatient);
    redraw();
}

void AngiogramView::setCamera(const core::ProjectionCamera& camera)
{
    interaction_->camera = camera;
    scene_.setCamera(camera);
    redraw();
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
    redraw();
}

void AngiogramView::setFramePosition(int index, int count)
{
    interaction_->frame = {index, count};
    redraw();
}

QString AngiogramView::frameText() const
{
    const auto [index, count] = interaction_->frame;
    return count > 1 ? tr("frame %1 of %2").arg(index + 1).arg(count) : QString();
}

void AngiogramView::setCornerTexts(const CornerTexts& texts)
{
    interaction_->annotations.texts = texts;
    redraw();
}

void AngiogramView::setResidualScale(double maximumPx, double maximumMm)
{
    interaction_->annotations.scaleMaximumPx = maximumPx;
    interaction_->annotations.scaleMaximumMm = maximumMm;
    redraw();
}

void AngiogramView::setLineWidth(double px)
{
    interaction_->lineWidth = px;
    redraw();
}

void AngiogramView::setMarks(std::vector<ImageMark> marks)
{
    if (!marks.empty() || !interaction_->marks.empty()) {
        interaction_->marks = std::move(marks);
        redraw();
    }
}

void AngiogramView::setPlacedMarks(std::vector<ImageMark> marks)
{
    if (!marks.empty() || !interaction_->placedMarks.empty()) {
        interaction_->placedMarks = std::move(marks);
        redraw();
    }
}

const std::vector<ImageMark>& AngiogramView::placedMarks() const
{
    return interaction_->placedMarks;
}

const std::vector<ImageMark>& AngiogramView::marks() const
{
    return interaction_->marks;
}

void AngiogramView::setCrosshair(const ImageCrosshair& crosshair)
{
    const ImageCrosshair& former = interaction_->crosshair;
    const bool isNothing = !crosshair.linePx && !crosshair.pointInPatient;
    if (!isNothing || former.linePx || former.pointInPatient) {
        interaction_->crosshair = crosshair;
        redraw();
    }
}

const ImageCrosshair& AngiogramView::crosshair() const
{
    return interaction_->crosshair;
}

void AngiogramView::setPlaceholderText(const QString& text)
{
    interaction_->absence = text;
    redraw();
}

void AngiogramView::copyAppearance(const AngiogramView& other)
{
    scene_.copyAppearance(other.scene_);
    interaction_->mouse = other.interaction_->mouse;
    interaction_->lineWidth = other.interaction_->lineWidth;
    interaction_->viewport.setMirrored(other.isFromSource());
    redraw();
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
    interaction_->cutout = {cutout_, imageFromWidget(position), lensRadius / zoom()};
    scene_.setCutout(interaction_->cutout);
    redraw();
}

void AngiogramView::setOrientationKnown(bool known)
{
    interaction_->isOrientationKnown = known;
    redraw();
}

void AngiogramView::setFromSource(bool fromSource)
{
    interaction_->viewport.setMirrored(fromSource);
    redraw();
}

bool AngiogramView::isFromSource() const
{
    return interaction_->viewport.isMirrored();
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
    redraw();
}

void AngiogramView::fitToWindow()
{
    interaction_->viewport.fit();
    emit zoomChanged(zoom());
    redraw();
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
    redraw();
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
    return interaction_->pickedPivot ? *interaction_->pickedPivot : interaction_->pivotInPatient;
}

std::optional<QPointF> AngiogramView::positionOf(const Eigen::Vector3d& pointInPatient) const
{
    const auto pixel =
        !core::findProblem(camera()) ? core::project(camera(), cameraFromPatient() * pointInPatient) : std::nullopt;
    return pixel ? std::optional(widgetFromImage(*pixel)) : std::nullopt;
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

}   // namespace angiopose::ui
