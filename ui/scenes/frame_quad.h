#pragma once

#include "ui/scenes/gray_frame.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// The frame as a textured rectangle from −0.5 to size − 0.5: pixel centres lie on integers. Whatever the frame and the
/// zoom, OpenGL is asked for the same kind of texture: in software, every other kind means a program that takes longer
/// to make than a picture may take to draw.
class FrameQuad {
public:
    FrameQuad();
    void show(const GrayFrame& frame, double devicePxPerImagePx);
    vtkActor* actor() { return actor_; }

private:
    void showPicture(const GrayFrame& frame, int halvings);
    void fitRectangle(int width, int height, int halvings);

    vtkNew<vtkImageData> picture_;
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
    vtkNew<vtkFloatArray> coordinates_;
    std::uint64_t shownRevision_ = 0;
    int shownHalvings_ = 0;
};

}   // namespace angiopose::ui