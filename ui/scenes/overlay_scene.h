#pragma once

#include "ui/scenes/overlay_content.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {

/// Scene with the angiogram and the projected tree: content, visible part and hit testing. Setters only store values
/// and mark them as changed; OverlayPainter and VtkOverlay render the content.
class OverlayScene {
public:
    OverlayScene();
    ~OverlayScene();
    OverlayScene(const OverlayScene&) = delete;
    OverlayScene& operator=(const OverlayScene&) = delete;

    void setFrame(const core::ImageF& frame);
    void setWindowLevel(double window, double level);
    void setInverted(bool inverted);
    void setInterpolation(Interpolation interpolation);
    void setTree(const core::VesselTree& tree);
    void setCamera(const core::ProjectionCamera& camera);
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setMarks(const BranchMarks& marks);
    void setMode(OverlayMode mode);
    void setOverlayHidden(bool hidden);   ///< temporarily hides tree and traced curves
    void setDepthCue(DepthCue cue);
    void setOpacity(double opacity);
    /// Sets the DRR of the vessels, bright on 0, which covers the whole frame at any resolution and is visible in every
    /// mode. An empty image removes the DRR.
    void setDrr(const core::ImageF& drr);
    void setCutout(const Cutout& cutout);
    void setLineWidthPx(double devicePixels);
    void setTracedCenterline(const core::Centerline2d& traced);   ///< drawn as thin dotted lines; hidden by default
    void showTracedCenterline(bool shown);

    /// Colors the tree by the distance to the traced vessels; `residualPx[branch id]` holds one value per tree point.
    /// Other values per point are possible if both arguments have the same unit.
    void setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx);
    void recolor();   ///< call after a change of the color scheme
    void clearResiduals();

    /// Copies marks, depth cueing, opacity, visibility of the traced curves and inversion from another scene, but
    /// neither content nor mode.
    void copyAppearance(const OverlayScene& other);

    void setViewRect(const ViewRect& rect);
    const core::ImageF& frame() const;
    OverlayMode mode() const;
    bool hasDrr() const;
    DepthCue depthCue() const;
    const Cutout& cutout() const;
    ViewRect viewRect() const;
    double lineWidthPx() const;

    /// Returns the content with the tree projected for the current camera and pose.
    const OverlayContent& content() const;

    /// State that determines the rendered image, apart from its size: equal stamps of one scene mean equal images.
    struct Stamp {
        std::uint64_t overlay = 0;
        std::uint64_t frame = 0;
        ViewRect rect;
        Cutout cutout;
        Interpolation interpolation = Interpolation::Smooth;

        bool operator==(const Stamp&) const = default;
    };
    Stamp stamp() const;

    /// Returns the nearest branch whose projection passes within `tolerancePx` (image px) of an image point.
    std::optional<int> branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const;

    /// Returns the bounding box of a branch in its current projection; nullopt if it is not in front of the source.
    std::optional<ViewRect> extentOf(int branchId) const;

    /// Returns whether the visible projected tree passes through this part of the image.
    bool treeIntersects(const ViewRect& part) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
