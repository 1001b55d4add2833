#pragma once

#include "ui/scenes/stroke_mesh.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace angiopose::ui {

/// VTK actor that draws a stroke mesh in pixel coordinates on top of everything else in its renderer.
class StrokeActor {
public:
    StrokeActor();
    void show(const StrokeMesh& mesh);
    vtkActor2D* actor() { return actor_; }

private:
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkActor2D> actor_;
};

}   // namespace angiopose::ui
