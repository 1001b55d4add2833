#pragma once

#include "ui/scenes/grey_frame.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace ui {

/// The frame as a textured rectangle from −0.5 to size − 0.5: pixel centres lie on integers.
class FrameQuad {
public:
    FrameQuad();
    void show(const GreyFrame& frame, double devicePxPerImagePx);
    vtkActor* actor() { return actor_; }

private:
    void showPicture(const GreyFrame& frame);
    void fitRectangle(int width, int height);

    vtkNew<vtkImageData> picture_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
    std::uint64_t shownRevision_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}   // namespace ui
