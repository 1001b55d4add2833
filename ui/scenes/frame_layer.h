#pragma once

#include "ui/scenes/shader_actor.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

namespace angiopose::ui {

/// Gray image as an OpenGL texture, uploaded only when the image changes.
class GrayTexture {
public:
    GrayTexture();
    void show(const core::Image2d<std::uint8_t>& picture, std::uint64_t revision);
    bool shows(std::uint64_t revision) const { return shownRevision_ == revision; }
    vtkTexture* texture() { return texture_; }

private:
    vtkNew<vtkImageData> data_;
    vtkNew<vtkTexture> texture_;
    std::uint64_t shownRevision_ = 0;
};

/// Layer that shows the angiogram over the whole viewport, with the DRR tint and the edge of the cutout.
class FrameLayer : public ShaderActor {
public:
    FrameLayer();
    void show(const OverlayContent& content, const ImagePlacement& placement);

private:
    void showGray(const OverlayContent& content);
    void showTint(const OverlayContent& content);

    GrayTexture frame_;
    GrayTexture drr_;
};

}   // namespace angiopose::ui
