#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/canvas.h"
#include "ui/scenes/cutout.h"
#include "ui/scenes/resample_frame.h"
#include "ui/scenes/view_rect.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace angiopose::ui {

/// How branches are shown, the same in every view.
struct BranchMarks {
    std::optional<int> hovered;
    std::set<int> selected;
    std::set<int> auxiliary;
    std::set<int> excluded;
    std::set<int> hidden;   ///< not in the scenes' trees; lists and slices show that

    bool operator==(const BranchMarks&) const = default;
};

enum class OverlayMode { Centerline, Outline, Tube, Hidden };

/// NearBright shows which vessels lie nearer to the source.
enum class DepthCue { None, NearBright };

/// The angiogram with the projected tree on it, drawn by the processor: no OpenGL, no Qt, so the same pixels come out
/// in the window, in the exported PNG and in the tests. Setters only store and mark; `draw` does the work, and keeps
/// the resampled angiogram while only the tree moves.
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

    /// Colours the tree by distance to the traced vessels; `residualPx[branch id]` holds one value per tree point.
    void setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx);
    void recolor();   ///< after another colour scheme was chosen
    void clearResiduals();

    void setViewRect(const ViewRect& rect);
    const core::ImageF& frame() const;
    OverlayMode mode() const;
    bool hasRadiograph() const;
    DepthCue depthCue() const;
    const Cutout& cutout() const;
    ViewRect viewRect() const;
    double lineWidthPx() const;

    /// Fills the canvas with what the view rectangle shows.
    void draw(Canvas canvas) { drawRows(canvas, 0, canvas.height); }

    /// The same for a part of a taller picture: rows `firstRow` … of `rowCount`.
    void drawRows(Canvas canvas, int firstRow, int rowCount);

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