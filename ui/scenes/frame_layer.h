#pragma once

#include "core/imaging/display_range.h"
#include "core/imaging/image2d.h"
#include "ui/scenes/overlay_scene.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

class vtkCamera;

namespace ui {

/// A frame brought to 8-bit grey by window and level; work happens only when somebody looks.
class GreyFrame {
public:
    void setPixels(const core::ImageF& pixels);
    void setRange(const core::DisplayRange& range);
    void setInverted(bool inverted);

    const core::ImageF& pixels() const { return pixels_; }
    int width() const { return pixels_.width; }
    int height() const { return pixels_.height; }
    vtkImageData* picture() const;   ///< one grey byte per pixel; row 0 is the top row of the frame

private:
    core::ImageF pixels_;
    core::DisplayRange range_;
    bool isInverted_ = false;
    mutable bool isStale_ = true;
    mutable vtkNew<vtkImageData> picture_;
};

/// The frame as a textured rectangle from −0.5 to size − 0.5: pixel centres lie on integers.
class FrameQuad {
public:
    FrameQuad();
    void show(const GreyFrame& frame, Interpolation interpolation, double devicePxPerImagePx);
    vtkActor* actor() { return actor_; }

private:
    vtkNew<vtkPolyData> rectangle_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkActor> actor_;
    int width_ = 0;
    int height_ = 0;
};

/// Parallel camera on the image plane, v down, whose picture is exactly `rect`.
void showImagePlane(vtkCamera& camera, const ViewRect& rect);

}   // namespace ui
