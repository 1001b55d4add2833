#pragma once

#include "ui/scenes/tree_scene.h"
#include "ui/views/vtk_view.h"

#include <QPointF>
#include <optional>

namespace angiopose::ui {

/// Labeled place on the vessels in the 3-D view: a point or a ring.
struct TreeMark {
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> ringInPatient;   ///< if empty, the place is a point
    QString label;
};

/// 3-D view of tree, X-ray source, detector with the image, beam edges and orientation letters. Left drag rotates,
/// middle drag pans, right drag and wheel zoom, a double-click requests enlarging; arrow keys rotate, + and − zoom.
class TreeView : public VtkView {
    Q_OBJECT
public:
    explicit TreeView(QWidget* parent = nullptr);
    ~TreeView() override;

    /// Renders every kind of object once off screen before the window appears, because software OpenGL takes 50 ms to
    /// compile each program.
    void warmUp();

    TreeScene& scene() { return scene_; }   ///< call requestRender() after changing the scene
    void setTheme(ThemeMode mode);
    void nextView();   ///< toggles between showing everything and only the vessels
    void setCrosshair(const std::optional<Eigen::Vector3d>& pointInPatient);   ///< position shown in the slices
    void setPointedPosition(
        const std::optional<Eigen::Vector3d>& pointInPatient);   ///< position pointed at in an image
    void showLandmarks(const std::vector<Eigen::Vector3d>& pointsInPatient,
                       const std::optional<Eigen::Vector3d>& pendingInPatient);   ///< landmarks are numbered from 1
    void showVesselMarks(std::vector<TreeMark> places);
    void setPickedPivot(const std::optional<Eigen::Vector3d>& pointInPatient);   ///< rotation center of the vessels

signals:
    void cameraChanged();   ///< emitted when rotated, moved, zoomed, resized or shown; requires a new scan rendering
    void enlargeRequested();   ///< requests maximizing, or restoring the layout
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void backgroundClicked();
    void pointPicked(const Eigen::Vector3d& pointInPatient);   ///< emitted with the picked point on the clicked branch
    void branchMenuRequested(int branchId, const Eigen::Vector3d& pointInPatient, const QPoint& globalPosition);
    void menuRequested(const QPoint& globalPosition, std::optional<int> branchId);

protected:
    void prepareFrame() override;
    void paintAnnotations(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    std::optional<TreePick> pickAt(const QPointF& position) const;
    void hover(std::optional<int> branchId);
    void paintVesselMarks(QPainter& painter) const;
    void paintPlaceholder(QPainter& painter) const;
    void reportCamera();

    TreeScene scene_;
    core::ParallelProjection renderedProjection_;   ///< view of the last rendering
    ThemeMode theme_ = ThemeMode::Dark;
    QPointF pressedAt_;
    QPointF lastAt_;
    Qt::MouseButton pressed_ = Qt::NoButton;
    bool isDragging_ = false;
    std::optional<int> hovered_;
    std::optional<Eigen::Vector3d> crosshair_;
    std::optional<Eigen::Vector3d> pointed_;
    std::vector<Eigen::Vector3d> landmarks_;
    std::vector<TreeMark> treeMarks_;
    bool isLastPending_ = false;
    std::optional<Eigen::Vector3d> pickedPivot_;
};

}   // namespace angiopose::ui
