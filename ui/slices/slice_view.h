#pragma once

#include "ui/slices/slice_model.h"

#include <QPointF>
#include <QWidget>

#include <optional>

namespace angiopose::ui {

struct SlicePointer;

/// View of one plane of the scan with mask, centerlines and crosshair. The left button sets the crosshair, middle drag
/// pans, right drag adjusts window/level, the wheel and ↑ ↓ scroll the slices, Ctrl+wheel zooms, Ctrl+arrows move the
/// crosshair, and a double-click requests enlarging. An active `SliceTool` takes precedence.
class SliceView : public QWidget {
    Q_OBJECT
public:
    SliceView(SliceModel& model, core::BodyPlane plane, QWidget* parent = nullptr);

    core::BodyPlane plane() const { return plane_; }
    void setPlane(core::BodyPlane plane);
    void fit();
    void stepBy(int slices);   ///< moves along the normal by a number of slices
    double pxPerMm() const;   ///< scale in widget px per mm
    QPointF widgetFromPatient(const Eigen::Vector3d& pointInPatient) const;
    Eigen::Vector3d patientFromWidget(const QPointF& position) const;   ///< returns the point in the slice plane
    const core::SliceGrid& grid();   ///< grid of the displayed slice
    bool wantsToolKey(const QKeyEvent& event) const;   ///< true if the tool handles the key before any shortcut
    QSize sizeHint() const override { return {320, 320}; }
    QSize minimumSizeHint() const override { return {80, 80}; }

signals:
    void pointPicked(const Eigen::Vector3d& pointInPatient);   ///< emitted on a left click, or Enter at the crosshair
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void menuRequested(const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition);
    void enlargeRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void resample();   ///< resamples if the crosshair has left the displayed slice
    void renderImage();
    SliceTints tints() const;
    void updateMaskTint(const core::BoundingBox& box);   ///< updates the displayed slice where the mask changed
    void changeWindow(const QPointF& step);
    bool scrollSlices(const QKeyEvent& event);   ///< false if the key does not scroll
    bool moveCrosshair(int key);
    std::optional<int> branchAt(const QPointF& position) const;
    void hover(const std::optional<QPointF>& position);
    SlicePointer pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers);
    bool dragTool(const QMouseEvent& event, bool isStart);
    bool filterToolKey(QKeyEvent& event);
    void followTool();
    QString sliceText() const;
    QStringList topTexts() const;
    QStringList positionTexts() const;

    SliceModel& model_;
    core::BodyPlane plane_;
    SliceContent content_;
    ImageViewport viewport_;
    QImage image_;
    bool isContentStale_ = true;
    bool isImageStale_ = true;
    Qt::MouseButton pressed_ = Qt::NoButton;
    bool isDragging_ = false;
    bool isToolDrag_ = false;
    QPointF pressedAt_;
    QPointF lastAt_;
    double wheelSteps_ = 0.0;
    std::optional<QPointF> pointer_;
    std::optional<int> hovered_;
};

}   // namespace angiopose::ui
