#pragma once

#include "ui/scenes/scan_picture.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// Shows a scan rendering as a plane in space through its center, facing its viewpoint. The plane turns with the view
/// until the next rendering arrives.
class ScanQuad {
public:
    ScanQuad();

    void show(const ScanPicture& picture);   ///< an empty one hides the quad
    vtkActor* actor() { return actor_; }

private:
    vtkNew<vtkImageData> picture_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
};

}   // namespace angiopose::ui
