#pragma once

#include "ui/scenes/gray_frame.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// Angiogram frame as a textured rectangle from −0.5 to size − 0.5, with pixel centers at integers. Uses the same kind
/// of texture for every frame and zoom, because software OpenGL compiles a program for each kind, and compiling takes
/// longer than the time budget of a frame.
class FrameQuad {
public:
    FrameQuad();
    void show(const GrayFrame& frame, double devicePxPerImagePx);
    vtkActor* actor() { return actor_; }

private:
    void uploadTexture(const GrayFrame& frame, int halvings);
    void fitRectangle(int width, int height, int halvings);

    vtkNew<vtkImageData> image_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
    vtkNew<vtkFloatArray> coordinates_;
    std::uint64_t shownRevision_ = 0;
    int shownHalvings_ = 0;
};

}   // namespace angiopose::ui
