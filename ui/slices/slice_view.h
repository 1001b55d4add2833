#pragma once

#include "ui/slices/slice_model.h"

#include <QPointF>
#include <QWidget>

#include <optional>

namespace angiopose::ui {

struct SlicePointer;

/// One plane of the scan with mask, centerlines and cross-hair. Left sets the cross-hair, middle drag pans, right drag
/// adjusts window/level, wheel and ↑ ↓ scroll the slices, Ctrl+wheel zooms, Ctrl+arrows move the cross-hair, double
/// click requests enlarging. A slice mode (`SliceTool`) takes precedence for the left button.
class SliceView : public QWidget {
    Q_OBJECT
public:
    SliceView(SliceModel& model, core::BodyPlane plane, QWidget* parent = nullptr);

    core::BodyPlane plane() const { return plane_; }
    void setPlane(core::BodyPlane plane);
    void fit();
    void stepBy(int slices);   ///< along the normal
    double pxPerMm() const;   ///< widget px
    QPointF widgetFromPatient(const Eigen::Vector3d& pointInPatient) const;
    Eigen::Vector3d patientFromWidget(const QPointF& position) const;   ///< in the plane of the slice
    const core::SliceGrid& grid();   ///< grid of the shown slice
    bool wantsToolKey(const QKeyEvent& event) const;   ///< the tool takes the key before any shortcut
    QSize sizeHint() const override { return {320, 320}; }
    QSize minimumSizeHint() const override { return {80, 80}; }

signals:
    void pointPicked(const Eigen::Vector3d& pointInPatient);   ///< left click, or Enter at the cross-hair
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void menuRequested(const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition);
    void roomRequested();

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
    void cut();   ///< resamples if the cross-hair left the shown slice
    void drawPicture();
    SliceTints tints() const;
    void retint(const core::TouchedBox& box);   ///< updates the shown slice where the mask changed
    void changeWindow(const QPointF& step);
    bool goThroughSlices(const QKeyEvent& event);   ///< false: not a scroll key
    bool moveCrosshair(int key);
    std::optional<int> branchAt(const QPointF& position) const;
    void hover(const std::optional<QPointF>& position);
    SlicePointer pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers);
    bool dragTool(const QMouseEvent& event, bool isStart);
    bool filterToolKey(QKeyEvent& event);
    void followTool();
    QString sliceText() const;
    QStringList topTexts() const;
    QStringList placeTexts() const;

    SliceModel& model_;
    core::BodyPlane plane_;
    SliceContent content_;
    ImageViewport viewport_;
    QImage picture_;
    bool isContentStale_ = true;
    bool isPictureStale_ = true;
    Qt::MouseButton pressed_ = Qt::NoButton;
    bool isDragging_ = false;
    bool isToolsDrag_ = false;
    QPointF pressedAt_;
    QPointF lastAt_;
    double wheelSteps_ = 0.0;
    std::optional<QPointF> pointer_;
    std::optional<int> hovered_;
};

}   // namespace angiopose::ui