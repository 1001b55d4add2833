#include "ui/views/tree_view.h"

#include "ui/actions/key_hint.h"
#include "ui/views/crosshair_mark.h"
#include "ui/views/paint_marks.h"
#include "ui/views/pivot_mark.h"
#include "ui/words/retranslation.h"

#include <vtkRenderWindow.h>
#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace angiopose::ui {
namespace {

constexpr double turnDegPerPx = 0.5;
constexpr double zoomPerStep = 1.15;

QColor colorOf(const Color& color)
{
    return {color.red, color.green, color.blue};
}

}   // namespace

TreeView::TreeView(QWidget* parent) : VtkView(parent)
{
    scene_.attachTo(renderWindow());
    withAccessibleName(this, [] { return tr("3-D view of vessel tree, X-ray source and detector"); });
}

TreeView::~TreeView() = default;

void TreeView::warmUp()
{
    TreeScene rehearsal;
    rehearsal.attachTo(renderWindow());
    core::VesselTree tree;
    tree.branches.emplace_back();
    tree.branches.front().pointsInPatient = {{0.0, 0.0, -10.0}, {0.0, 0.0, 10.0}};
    tree.branches.front().radiusMm = {1.0, 1.0};
    rehearsal.setTree(tree);
    constexpr int size = 9;
    rehearsal.setCamera({100.0, 100.0, 4.0, 4.0, size, size}, 1000.0);
    core::RigidTransform cameraFromPatient;
    cameraFromPatient.translation.z() = 750.0;
    rehearsal.setPose(cameraFromPatient);
    rehearsal.setFrame(core::ImageF(size, size, 1.0F));
    core::ParallelProjection projection;
    projection.width = projection.height = size;
    rehearsal.setScanRendering({projection, core::Image2d<core::Rgba>(size, size)});
    renderHidden();
}

void TreeView::setTheme(ThemeMode mode)
{
    theme_ = mode;
    scene_.setColors(ui::palette(mode));
    requestRender();
}

void TreeView::nextView()
{
    scene_.nextView();
    requestRender();
}

void TreeView::setCrosshair(const std::optional<Eigen::Vector3d>& pointInPatient)
{
    if (pointInPatient != crosshair_) {
        crosshair_ = pointInPatient;
        update();
    }
}

void TreeView::setPointedPosition(const std::optional<Eigen::Vector3d>& pointInPatient)
{
    if (pointInPatient != pointed_) {
        pointed_ = pointInPatient;
        update();
    }
}

void TreeView::showLandmarks(const std::vector<Eigen::Vector3d>& pointsInPatient,
                             const std::optional<Eigen::Vector3d>& pendingInPatient)
{
    landmarks_ = pointsInPatient;
    isLastPending_ = pendingInPatient.has_value();
    if (pendingInPatient) {
        landmarks_.push_back(*pendingInPatient);
    }
    update();
}

void TreeView::showVesselMarks(std::vector<TreeMark> places)
{
    if (!places.empty() || !treeMarks_.empty()) {
        treeMarks_ = std::move(places);
        update();
    }
}

/// Paints the labeled marks like image marks, in the colors of the theme.
void TreeView::paintVesselMarks(QPainter& painter) const
{
    const double ratio = devicePixelRatio();
    const auto positionOf = [&](const Eigen::Vector3d& point) -> Eigen::Vector2d {
        const Eigen::Vector2d device = scene_.deviceFromPatient(point);
        return {device.x() / ratio, height() - device.y() / ratio};
    };
    std::vector<ImageMark> marks;
    for (const TreeMark& place : treeMarks_) {
        ImageMark& mark = marks.emplace_back();
        mark.shape = place.ringInPatient.empty() ? MarkShape::Point : MarkShape::Outline;
        mark.label = place.label.toStdString();
        mark.tone = MarkTone::Place;
        for (const Eigen::Vector3d& point : place.ringInPatient) {
            mark.pixels.push_back(positionOf(point));
        }
        if (mark.pixels.empty()) {
            mark.pixels = {positionOf(place.pointInPatient)};
        }
    }
    const Palette& colors = ui::palette(theme_);
    const LabelObstacles obstacles{1.0 * width(), 1.0 * height(), {}, {}};
    paintMarks(painter, marks, [](const Eigen::Vector2d& at) { return at; }, {obstacles, colors, colors.field});
}

void TreeView::setPickedPivot(const std::optional<Eigen::Vector3d>& pointInPatient)
{
    if (pointInPatient != pickedPivot_) {
        pickedPivot_ = pointInPatient;
        update();
    }
}

void TreeView::prepareFrame()
{
    scene_.setPixelScale(devicePixelRatio());
}

/// Emits `cameraChanged` if the view changed; called after drawing, which may frame the view.
void TreeView::reportCamera()
{
    constexpr int anyPx = 1'000'000'000;
    const core::ParallelProjection projection = scene_.projection(anyPx);
    if (projection != renderedProjection_) {
        renderedProjection_ = projection;
        QMetaObject::invokeMethod(this, &TreeView::cameraChanged, Qt::QueuedConnection);   // not during painting
    }
}

void TreeView::paintPlaceholder(QPainter& painter) const
{
    const int margin = std::min(24, width() / 12);
    painter.setPen(colorOf(ui::palette(theme_).label));
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No vessels yet: drop them here, open them (%1), or trace a scan in its slices (%2).")
                         .arg(keyOf(Command::Open), keyOf(Command::SlicesLarge)));
}

void TreeView::paintAnnotations(QPainter& painter)
{
    reportCamera();
    if (scene_.isEmpty()) {
        paintPlaceholder(painter);
        return;
    }
    const Palette& colors = ui::palette(theme_);
    const double ratio = devicePixelRatio();
    for (const auto& place : {crosshair_, pointed_}) {
        if (place) {
            const Eigen::Vector2d device = scene_.deviceFromPatient(*place);
            paintCrosshairMark(painter, {device.x() / ratio, height() - device.y() / ratio}, colors);
        }
    }
    QFont small = font();
    small.setPixelSize(11);
    painter.setFont(small);
    for (std::size_t i = 0; i < landmarks_.size(); ++i) {
        const Eigen::Vector2d device = scene_.deviceFromPatient(landmarks_[i]);
        const QPointF at(device.x() / ratio, height() - device.y() / ratio);
        const bool isPending = isLastPending_ && i + 1 == landmarks_.size();
        painter.setPen(QPen(colorOf(isPending ? colors.attention : colors.accent), 1.6));
        painter.drawEllipse(at, 5.0, 5.0);
        painter.setPen(colorOf(colors.textStrong));
        painter.drawText(at + QPointF(7.0, -5.0), QString::number(i + 1));
    }
    paintVesselMarks(painter);
    if (pickedPivot_) {
        const Eigen::Vector2d device = scene_.deviceFromPatient(*pickedPivot_);
        paintPivotMark(painter, {device.x() / ratio, height() - device.y() / ratio}, colors);
    }
    for (const OrientationLetter& letter : scene_.orientationLetters()) {
        const QPointF at(letter.at.x() / ratio, height() - letter.at.y() / ratio);
        painter.setPen(colorOf(letter.pointsToViewer ? colors.text : colors.hint));
        painter.drawText(QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, QString(QChar(letter.letter)));
    }
}

void TreeView::mousePressEvent(QMouseEvent* event)
{
    if (pressed_ == Qt::NoButton) {
        pressed_ = event->button();
        pressedAt_ = lastAt_ = event->position();
        isDragging_ = false;
    }
}

void TreeView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF step = event->position() - lastAt_;
    if (pressed_ == Qt::NoButton) {
        const auto pick = pickAt(event->position());
        hover(pick ? std::optional(pick->branchId) : std::nullopt);
        return;
    }
    const QPointF offset = event->position() - pressedAt_;
    isDragging_ = isDragging_ || 2.0 * offset.manhattanLength() >= QApplication::startDragDistance();
    if (!isDragging_) {
        return;
    }
    lastAt_ = event->position();
    if (pressed_ == Qt::LeftButton) {
        scene_.turnBy(turnDegPerPx * step.x(), turnDegPerPx * step.y());
    } else if (pressed_ == Qt::MiddleButton) {
        scene_.panBy(step.x() * devicePixelRatio(), -step.y() * devicePixelRatio());
    } else {
        scene_.zoomBy(std::exp(-0.008 * step.y()));
    }
    requestRender();
}

void TreeView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != pressed_) {
        return;
    }
    pressed_ = Qt::NoButton;
    const auto pick = isDragging_ ? std::nullopt : pickAt(event->position());
    if (pick && event->button() == Qt::RightButton) {
        emit branchMenuRequested(pick->branchId, pick->pointInPatient, event->globalPosition().toPoint());
    } else if (!isDragging_ && event->button() == Qt::RightButton) {
        emit menuRequested(event->globalPosition().toPoint(), std::nullopt);
    }
    if (isDragging_ || event->button() != Qt::LeftButton) {
        return;
    }
    if (pick) {
        emit branchClicked(pick->branchId, event->modifiers());
        emit pointPicked(pick->pointInPatient);
    } else {
        emit backgroundClicked();
    }
}

void TreeView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) {
        emit enlargeRequested();
    }
}

void TreeView::keyPressEvent(QKeyEvent* event)
{
    constexpr double turnDeg = 10.0;
    switch (event->key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
            scene_.turnBy(event->key() == Qt::Key_Left ? -turnDeg : turnDeg, 0.0);
            break;
        case Qt::Key_Up:
        case Qt::Key_Down:
            scene_.turnBy(0.0, event->key() == Qt::Key_Up ? -turnDeg : turnDeg);
            break;
        case Qt::Key_Plus:
        case Qt::Key_Minus:
            scene_.zoomBy(event->key() == Qt::Key_Plus ? zoomPerStep : 1.0 / zoomPerStep);
            break;
        default:
            VtkView::keyPressEvent(event);
            return;
    }
    requestRender();
}

/// Handles the menu key; with the mouse, the menu opens when the right button is released without a drag.
void TreeView::contextMenuEvent(QContextMenuEvent* event)
{
    event->accept();
    if (event->reason() == QContextMenuEvent::Keyboard) {
        emit menuRequested(mapToGlobal(rect().center()), hovered_);
    }
}

void TreeView::wheelEvent(QWheelEvent* event)
{
    scene_.zoomBy(std::pow(zoomPerStep, event->angleDelta().y() / 120.0));
    event->accept();
    requestRender();
}

void TreeView::showEvent(QShowEvent* event)
{
    VtkView::showEvent(event);
    renderedProjection_ = {};   // forces `cameraChanged`, since no scan rendering was requested while hidden
}

void TreeView::leaveEvent(QEvent*)
{
    hover(std::nullopt);
}

std::optional<TreePick> TreeView::pickAt(const QPointF& position) const
{
    const double ratio = devicePixelRatio();
    return scene_.pickAt(static_cast<int>(position.x() * ratio), static_cast<int>((height() - position.y()) * ratio));
}

void TreeView::hover(std::optional<int> branchId)
{
    if (branchId != hovered_) {
        hovered_ = branchId;
        setCursor(branchId ? Qt::PointingHandCursor : Qt::ArrowCursor);
        emit branchHovered(branchId);
    }
}

}   // namespace angiopose::ui
