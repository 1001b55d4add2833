#pragma once

#include "ui/scenes/scan_picture.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// Such a picture as a pane in space, through the point that it was centred on, facing where it was seen from. While
/// the view turns and the next picture is on its way the pane turns along.
class ScanQuad {
public:
    ScanQuad();

    void show(const ScanPicture& picture);   ///< an empty one: nothing
    vtkActor* actor() { return actor_; }

private:
    vtkNew<vtkImageData> picture_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
};

}   // namespace angiopose::ui
