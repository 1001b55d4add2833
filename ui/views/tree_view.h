#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "core/imaging/image2d.h"
#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/tree_scene.h"
#include "ui/views/vtk_view.h"

namespace ui {

/// The 3-D situation: tree, X-ray source, detector with the image, beam edges, orientation letters. Left drag turns.
class TreeView : public VtkView {
    Q_OBJECT
public:
    explicit TreeView(QWidget* parent = nullptr);

    TreeScene& scene() { return scene_; }   ///< call update() after changing it
    void resetView();

signals:
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);

private:
    TreeScene scene_;
};

}   // namespace ui
