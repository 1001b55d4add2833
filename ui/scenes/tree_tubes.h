#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTubeFilter.h>

namespace angiopose::ui {

/// Renders the tree as shaded tubes in patient space; excluded branches are thin and dashed, selected ones thick.
class TreeTubes {
public:
    TreeTubes();
    void show(const core::VesselTree& tree, const BranchMarks& marks, const Palette& colors);
    vtkActor* actor() { return actor_; }

private:
    vtkNew<vtkPolyData> lines_;
    vtkNew<vtkTubeFilter> tubes_;
    vtkNew<vtkActor> actor_;
};

}   // namespace angiopose::ui
