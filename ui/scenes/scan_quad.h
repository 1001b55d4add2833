#pragma once

#include "ui/scenes/scan_rendering.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// Shows a rendering of the scan on a plane through the center of the scan, facing the viewpoint of the rendering. The
/// plane turns with the view until the next rendering arrives.
class ScanQuad {
public:
    ScanQuad();

    void show(const ScanRendering& image);   ///< an empty image hides the plane
    vtkActor* actor() { return actor_; }

private:
    vtkNew<vtkImageData> image_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
};

}   // namespace angiopose::ui
