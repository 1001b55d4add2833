#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"

#include <memory>
#include <optional>

namespace ui {

/// Tree, source, detector plane with the image, and beam, in patient space. VTK without Qt.
class TreeScene {
public:
    TreeScene();
    ~TreeScene();
    TreeScene(const TreeScene&) = delete;
    TreeScene& operator=(const TreeScene&) = delete;

    void setTree(const core::VesselTree& tree);
    void setCamera(const core::ProjectionCamera& camera, double sourceToDetectorMm);
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setFrame(const core::ImageF& frame);
    void setMarks(const BranchMarks& marks);
    void attachTo(vtkRenderWindow* window);
    void resetView();
    std::optional<int> branchAt(int xDevicePx, int yDevicePxFromBottom) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}   // namespace ui
