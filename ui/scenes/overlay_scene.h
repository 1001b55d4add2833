#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"
#include "core/vessel/vessel_tree.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

class vtkRenderWindow;

namespace ui {

/// Visible part of the image in pixel coordinates (pixel centres at integers, v down).
struct ViewRect {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

    bool operator==(const ViewRect&) const = default;
};

/// How branches are shown, the same in every view.
struct BranchMarks {
    std::optional<int> hovered;
    std::set<int> selected;
    std::set<int> auxiliary;
    std::set<int> excluded;

    bool operator==(const BranchMarks&) const = default;
};

enum class OverlayMode { Centerline, Outline, Hidden };

/// Smooth blends between pixels; Nearest shows every pixel as it is.
enum class Interpolation { Smooth, Nearest };

/// The angiogram with the projected tree on it. VTK without Qt: the same scene draws the window, the exported PNG and
/// the tests. Setters only store and mark; nothing renders until the window does.
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
    void setOpacity(double opacity);
    void setLineWidthPx(double devicePixels);
    void setTracedCenterline(const core::Centerline2d& traced);   ///< thin dotted curves, hidden unless shown
    void showTracedCenterline(bool shown);

    /// Colours the tree by distance to the traced vessels; `residualPx[branch id]` holds one value per tree point.
    void setResiduals(const std::map<int, std::vector<double>>& residualPx, double scaleMaximumPx);
    void clearResiduals();

    void setViewRect(const ViewRect& rect);
    const core::ImageF& frame() const;
    ViewRect viewRect() const;
    double lineWidthPx() const;

    void attachTo(vtkRenderWindow* window);   ///< adds its layer to the window; several windows may show one scene
    void detachFrom(vtkRenderWindow* window);

    /// Branch whose projection passes within `tolerancePx` (image px) of an image point; the nearest one.
    std::optional<int> branchAt(const Eigen::Vector2d& imagePoint, double tolerancePx) const;

    /// True when the projected tree, as shown, passes through this part of the image.
    bool treePasses(const ViewRect& part) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace ui
