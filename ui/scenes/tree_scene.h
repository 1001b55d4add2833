#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/orientation_marker.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/scan_rendering.h"
#include "ui/theme/theme.h"

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderWindow;

namespace angiopose::ui {

/// Position that was picked on the tree.
struct TreePick {
    int branchId = 0;
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
};

/// 3-D scene in patient space: tree, X-ray source, beam, detector plane with the image, and the scan behind the tree.
/// Uses VTK without Qt; attached to a single window for its lifetime.
class TreeScene {
public:
    TreeScene();
    ~TreeScene();
    TreeScene(const TreeScene&) = delete;
    TreeScene& operator=(const TreeScene&) = delete;

    void setTree(const core::VesselTree& tree);   ///< keeps the view unless the new tree lies elsewhere
    void setCamera(const core::ProjectionCamera& camera, double sourceToDetectorMm);   ///< distance 0: no detector
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setFrame(const core::ImageF& frame);
    /// Replaces the frame with an image of any resolution that covers it completely; empty restores the frame.
    void setDetectorImage(const core::ImageF& image);
    /// Sets the extent of the scan, to which the view is framed if there is no tree; without a value, no scan is shown.
    void setScanBox(const std::optional<Eigen::AlignedBox3d>& boxInPatient);
    void setScanRendering(
        const ScanRendering& image);   ///< sets the rendering for `sight()`; an empty image shows none
    /// Returns the current view, for rendering an image of at most `maxPx` pixels.
    core::ParallelProjection projection(int maxPx) const;
    void setMarks(const BranchMarks& marks);
    void setColors(const Palette& colors);
    void setPixelScale(double devicePxPerPx);   ///< scales the line widths and the orientation marker
    void attachTo(vtkRenderWindow* window);   ///< call this once

    /// Shows the beam from the side, with the X-ray source at the top and everything in view; the next call shows only
    /// the vessels.
    void nextView();
    void reframe();   ///< brings all content into view unless the user has changed the view
    void turnBy(double rightDeg, double downDeg);   ///< rotates the scene by a mouse movement
    void zoomBy(double factor);
    void panBy(double rightDevicePx, double upDevicePx);

    bool isEmpty() const;   ///< true without vessels and scan, when nothing is drawn
    std::optional<TreePick> pickAt(int xDevicePx, int yDevicePxFromBottom) const;
    Eigen::Vector2d deviceFromPatient(const Eigen::Vector3d& pointInPatient) const;   ///< px from the bottom left
    std::vector<OrientationLetter> orientationLetters() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui
