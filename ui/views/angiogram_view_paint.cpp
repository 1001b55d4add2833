// The drawing half of AngiogramView.
#include "ui/actions/key_hint.h"
#include "ui/scenes/fill_strokes.h"
#include "ui/theme/active_theme.h"
#include "ui/views/angiogram_interaction.h"
#include "ui/views/crosshair_mark.h"
#include "ui/views/cutout_edge.h"
#include "ui/views/gl_driver.h"
#include "ui/views/gl_overlay.h"
#include "ui/views/paint_marks.h"
#include "ui/views/pivot_mark.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace angiopose::ui {
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

void AngiogramView::setKeptOut(const core::Mask2d& fieldMask)
{
    interaction_->keptOut = fieldMask.isEmpty() ? QImage() : hatched(fieldMask);
    update();
}

bool AngiogramView::showsVessels() const
{
    return scene_.treePasses(interaction_->viewport.imageRectOf({0.0, 0.0}, {1.0 * width(), 1.0 * height()}));
}

void AngiogramView::paintPivot(QPainter& painter) const
{
    const auto place = interaction_->pickedPivot && showsVessels() ? placeOf(*interaction_->pickedPivot) : std::nullopt;
    if (place) {
        paintPivotMark(painter, *place, ui::palette(ThemeMode::Dark));
    }
}

void AngiogramView::paintCrosshair(QPainter& painter) const
{
    const ImageCrosshair& crosshair = interaction_->crosshair;
    const auto place = crosshair.pointInPatient ? placeOf(*crosshair.pointInPatient) : std::nullopt;
    if (crosshair.linePx) {
        paintEpipolarLine(painter,
                          {widgetFromImage(crosshair.linePx->beginPx), widgetFromImage(crosshair.linePx->endPx)},
                          ui::palette(ThemeMode::Dark));
    }
    if (place) {
        paintPlaceMark(painter, *place, ui::palette(ThemeMode::Dark));
    }
}

/// Measured and placed ones together: their labels make room for each other and for the vessels.
void AngiogramView::paintAllMarks(QPainter& painter) const
{
    std::vector<ImageMark> all = interaction_->marks;
    all.insert(all.end(), interaction_->placedMarks.begin(), interaction_->placedMarks.end());
    if (all.empty()) {
        return;
    }
    const auto placeOf = [this](const Eigen::Vector2d& pixel) -> Eigen::Vector2d {
        const QPointF place = widgetFromImage(pixel);
        return {place.x(), place.y()};
    };
    MarkGround ground;
    ground.width = width();
    ground.height = height();
    for (const QRectF& bar : barPlaces()) {
        ground.taken.push_back({bar.left(), bar.right(), bar.top(), bar.bottom()});
    }
    if (scene_.mode() != OverlayMode::Hidden) {
        for (const ProjectedBranch& branch : scene_.content().projected) {
            for (const std::vector<ProjectedPoint>& run : branch.runs) {
                for (const ProjectedPoint& point : run) {
                    ground.avoided.push_back(placeOf(point.px));
                }
            }
        }
    }
    paintMarks(painter, all, placeOf, std::move(ground));
}

void AngiogramView::paintAbsence(QPainter& painter) const
{
    const bool isWorking = interaction_->role == ImageRole::Working;
    const int margin = std::min(24, width() / 12);
    painter.setPen(toQColor(ui::palette(ThemeMode::Dark).label));
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                     isWorking ? tr("No angiogram yet: drop one here, or open it (%1).").arg(keyOf(Command::Open))
                               : interaction_->absence);
}

/// The keys of the review, where there are vessels to look at: they are about the working image.
QString AngiogramView::keyText() const
{
    constexpr int narrowPx = 360;   // where the line would be cut
    if (interaction_->role == ImageRole::Working && width() >= narrowPx && showsVessels()) {
        return tr("flicker %1 · swipe %2 · hide H · outline %3")
            .arg(keyOf(Command::Flicker), keyOf(Command::Swipe), keyOf(Command::Outline));
    }
    return {};
}

std::vector<QRectF> AngiogramView::barPlaces() const
{
    std::vector<QRectF> places;
    for (const QWidget* bar : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (bar->isVisible()) {
            places.emplace_back(bar->geometry());
        }
    }
    return places;
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
    render(canvas, interaction_->tool ? interaction_->tool->strokes(canvas.height) : StrokeMesh{});
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

void AngiogramView::paintEvent(QPaintEvent*)
{
    drawPicture();
    ++renderCount_;
    QPainter painter(this);
    painter.drawImage(QPointF(0.0, 0.0), picture_);
    if (!interaction_->hasFrame) {
        paintAbsence(painter);
        return;
    }
    if (!interaction_->keptOut.isNull()) {
        const QPointF topLeft = widgetFromImage({-0.5, -0.5});
        const QSizeF covered = QSizeF(interaction_->keptOut.size()) * zoom();
        painter.drawImage(QRectF(topLeft, covered), interaction_->keptOut);
    }
    if (cutout_ != Cutout::Shape::None) {
        paintCutoutEdge(painter, cutoutPath(interaction_->cutout, interaction_->viewport, size()));
    }
    interaction_->annotations.mmPerImagePx = interaction_->mmPerImagePx();
    const bool isVeiled = interaction_->tool && interaction_->tool->hidesOverlay();
    interaction_->annotations.hidesScale = scene_.hasRadiograph() || isVeiled;
    interaction_->annotations.taken = barPlaces();
    interaction_->annotations.sides = interaction_->isOrientationKnown
                                          ? imageSides(interaction_->camera, interaction_->cameraFromPatient)
                                          : ImageSides{};
    interaction_->annotations.sideMark = sideMark();
    interaction_->annotations.frameText = frameText();
    interaction_->annotations.keyText = keyText();
    if (isFromSource()) {
        std::swap(interaction_->annotations.sides.left, interaction_->annotations.sides.right);
    }
    painter.setFont(font());
    interaction_->annotations.mode =
        interaction_->tool ? ModeLabel{interaction_->tool->caption(), interaction_->tool->tone()} : ModeLabel{};
    ui::paintAnnotations(painter, size(), interaction_->annotations, interaction_->viewport, scene_);
    paintPivot(painter);
    paintCrosshair(painter);
    if (!isVeiled) {
        paintAllMarks(painter);
    }
    if (interaction_->tool) {
        painter.setRenderHint(QPainter::Antialiasing);
        interaction_->tool->paint(painter);
    }
}

}   // namespace angiopose::ui