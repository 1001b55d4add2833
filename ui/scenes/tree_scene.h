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

/// A place on the tree that was pointed at.
struct TreePick {
    int branchId = 0;
    Eigen::Vector3d pointInPatient = Eigen::Vector3d::Zero();
};

/// Tree, source, detector plane with the image, beam, and the scan behind the tree, in patient space. VTK without Qt;
/// shows in one window, while it lives.
class TreeScene {
public:
    TreeScene();
    ~TreeScene();
    TreeScene(const TreeScene&) = delete;
    TreeScene& operator=(const TreeScene&) = delete;

    void setTree(const core::VesselTree& tree);   ///< keeps the view, unless the tree lies elsewhere
    void setCamera(const core::ProjectionCamera& camera, double sourceToDetectorMm);   ///< 0: the detector stays hidden
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setFrame(const core::ImageF& frame);
    /// In place of the frame, covering it whole at any resolution; empty: the frame again.
    void setDetectorPicture(const core::ImageF& picture);
    /// Where the scan lies: what there is to see where no tree is; nothing: no scan is shown.
    void setScanBox(const std::optional<Eigen::AlignedBox3d>& boxInPatient);
    void setScanPicture(const ScanPicture& picture);   ///< of `sight()`; empty: none
    /// How the scene is seen now, in a picture of `maxPx` pixels at most.
    core::ParallelSight sight(int maxPx) const;
    void setMarks(const BranchMarks& marks);
    void setTones(const Palette& tones);
    void setPixelScale(double devicePxPerPx);   ///< line widths and the orientation sign grow with it
    void attachTo(vtkRenderWindow* window);   ///< once

    /// Looks along the beam from the side, source above: everything in view; where it is so already, the vessels alone.
    void nextView();
    void frameAgain();   ///< what moved out of sight comes back, unless the user has turned or moved the view
    void turnBy(double rightDeg, double downDeg);   ///< turns what is seen under the mouse
    void zoomBy(double factor);
    void panBy(double rightDevicePx, double upDevicePx);

    bool isEmpty() const;   ///< neither vessels nor a scan: nothing is drawn
    std::optional<TreePick> pickAt(int xDevicePx, int yDevicePxFromBottom) const;
    Eigen::Vector2d deviceFromPatient(const Eigen::Vector3d& pointInPatient) const;   ///< px from the bottom left
    std::vector<OrientationLetter> orientationLetters() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::ui