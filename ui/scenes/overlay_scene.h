#pragma once

#include "ui/scenes/overlay_content.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::ui {

/// The angiogram with the projected tree on it: what is shown, where it lies on the image, and what a place on the
/// image belongs to. Setters only store and mark; renderers draw its content (OverlayPainter, VtkOverlay).
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
    void setVeiled(bool veiled);   ///< neither tree nor traced curves for a while
    void setDepthCue(DepthCue cue);
    void setOpacity(double opacity);
    /// Of the vessels, over the whole frame at any resolution, bright on 0; shown whatever the mode. Empty: none.
    void setRadiograph(const core::ImageF& radiograph);
    void setCutout(const Cutout& cutout);
    void setLineWidthPx(double devicePixels);
    void setTracedCenterline(const core::Centerline2d& traced);   ///< thin dotted curves, hidden unless shown
    void showTracedCenterline(bool shown);

    /// Colours the tree by distance to the traced vessels; `residualPx[branch id]` holds one value per tree point. Any
    /// other value of its points is coloured alike, with its own unit for both.
    void setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx);
    void recolor();   ///< after another colour scheme was chosen
    void clearResiduals();

    /// Marks, depth cue, opacity, traced curves and inversion as in the other scene; what is shown, and as what, stays.
    void takeLookOf(const OverlayScene& other);

    void setViewRect(const ViewRect& rect);
    const core::ImageF& frame() const;
    OverlayMode mode() const;
    bool hasRadiograph() const;
    DepthCue depthCue() const;
    const Cutout& cutout() const;
    ViewRect viewRect() const;
    double lineWidthPx() const;

    /// With the tree projected as camera and pose are now.
    const OverlayContent& content() const;

    /// What the picture hangs on besides its size: equal stamps of one scene, equal pictures.
    struct Stamp {
        std::uint64_t overlay = 0;
        std::uint64_t frame = 0;
        ViewRect rect;
        Cutout cutout;
        Interpolation interpolation = Interpolation::Smooth;

        bool operator==(const Stamp&) const = default;
    };
    Stamp stamp() const;

    /// Branch whose projection passes within `tolerancePx` (image px) of an image point; the nearest one.
    std::optional<int> branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const;

    /// What a branch covers of the image as it is projected now; nothing when it is not in front of the source.
    std::optional<ViewRect> extentOf(int branchId) const;

    /// True when the projected tree, as shown, passes through this part of the image.
    bool treePasses(const ViewRect& part) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui