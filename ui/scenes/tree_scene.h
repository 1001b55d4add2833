#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/orientation_sign.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/scan_picture.h"
#include "ui/theme/theme.h"

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderWindow;

namespace angiopose::ui {

/// Picked position on the tree.
struct TreePick {
    int branchId = 0;
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
};

/// Tree, source, detector plane with the image, beam, and the scan behind the tree, in patient space. Uses VTK without
/// Qt; attached to a single window for its lifetime.
class TreeScene {
public:
    TreeScene();
    ~TreeScene();
    TreeScene(const TreeScene&) = delete;
    TreeScene& operator=(const TreeScene&) = delete;

    void setTree(const core::VesselTree& tree);   ///< keeps the view unless the tree is elsewhere
    void setCamera(const core::ProjectionCamera& camera, double sourceToDetectorMm);   ///< 0: hides the detector
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setFrame(const core::ImageF& frame);
    /// Replaces the frame with an image of any resolution that covers it completely; empty restores the frame.
    void setDetectorPicture(const core::ImageF& picture);
    /// Sets the extent of the scan, which is framed if there is no tree; empty: no scan is shown.
    void setScanBox(const std::optional<Eigen::AlignedBox3d>& boxInPatient);
    void setScanPicture(const ScanPicture& picture);   ///< rendered for `sight()`; empty: none
    /// Returns the current view for an image of at most `maxPx` pixels.
    core::ParallelSight sight(int maxPx) const;
    void setMarks(const BranchMarks& marks);
    void setTones(const Palette& tones);
    void setPixelScale(double devicePxPerPx);   ///< scales line widths and the orientation sign
    void attachTo(vtkRenderWindow* window);   ///< call once

    /// Looks along the beam from the side, source at the top, with everything in view; a second call shows only the
    /// vessels.
    void nextView();
    void frameAgain();   ///< brings content back into view unless the user has changed the view
    void turnBy(double rightDeg, double downDeg);   ///< rotates the scene with the mouse
    void zoomBy(double factor);
    void panBy(double rightDevicePx, double upDevicePx);

    bool isEmpty() const;   ///< neither vessels nor scan: nothing is drawn
    std::optional<TreePick> pickAt(int xDevicePx, int yDevicePxFromBottom) const;
    Eigen::Vector2d deviceFromPatient(const Eigen::Vector3d& pointInPatient) const;   ///< px from the bottom left
    std::vector<OrientationLetter> orientationLetters() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui