#pragma once

#include "core/geometry/pose_offset.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/render_offscreen.h"
#include "ui/views/vtk_view.h"

#include <optional>

namespace ui {

/// The angiogram with the projected tree: window/level (left drag), pan (middle), zoom (right, Ctrl+wheel), frames
/// (wheel, ↑ ↓, Home, End). In nudge mode the left button drags the tree: inside the ring shifts, on the ring rolls;
/// Esc takes the drag back. Shows what it is told, reports what the user wants; decides nothing.
class AngiogramView : public VtkView {
    Q_OBJECT
public:
    explicit AngiogramView(QWidget* parent = nullptr);
    ~AngiogramView() override;

    OverlayScene& scene() { return scene_; }   ///< call update() after changing it
    void setPivot(const Eigen::Vector3d& pivotInPatient);   ///< centroid of the tree: where ring and cross sit
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setCamera(const core::ProjectionCamera& camera);
    void setFrame(const core::ImageF& frame);   ///< keeps zoom and window/level when the size stays
    void setCornerTexts(const CornerTexts& texts);   ///< top corners; the bottom left is the view's own
    void setNudgeMode(bool on);
    bool isNudgeMode() const { return nudgeMode_; }
    void setResidualScale(double maximumPx, double maximumMm);   ///< 0 hides the scale
    void fitToWindow();
    void autoWindowLevel();
    double zoom() const;   ///< device-independent px per image px
    Eigen::Vector2d imageFromWidget(const QPointF& position) const;
    QPointF widgetFromImage(const Eigen::Vector2d& imagePoint) const;

signals:
    void frameStepRequested(int step);   ///< ±1, ±10; INT_MIN first, INT_MAX last
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void backgroundClicked();
    void dragStarted();
    void dragged(const core::PoseOffset& offsetSinceStart);   ///< right/up mm at the pivot's depth, or roll
    void dragFinished();
    void dragCancelled();
    void windowLevelChanged(double window, double level);
    void zoomChanged(double zoom);

private:
    struct Interaction;
    OverlayScene scene_;
    std::unique_ptr<Interaction> interaction_;
    bool nudgeMode_ = false;
};

}   // namespace ui
