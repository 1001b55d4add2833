#include "ui/scenes/frame_layer.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <utility>

namespace ui {

void GreyFrame::setPixels(const core::ImageF& pixels)
{
    pixels_ = pixels;
    isStale_ = true;
}

void GreyFrame::setRange(const core::DisplayRange& range)
{
    range_ = range;
    isStale_ = true;
}

void GreyFrame::setInverted(bool inverted)
{
    isStale_ = isStale_ || inverted != isInverted_;
    isInverted_ = inverted;
}

vtkImageData* GreyFrame::picture() const
{
    if (!std::exchange(isStale_, false) || pixels_.isEmpty()) {
        return picture_;
    }
    const int* dimensions = picture_->GetDimensions();
    if (dimensions[0] != pixels_.width || dimensions[1] != pixels_.height) {
        picture_->SetDimensions(pixels_.width, pixels_.height, 1);
        picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    }
    const double span = range_.window();
    const auto gain = static_cast<float>(span > 0.0 ? 255.0 / span : 1e30);
    const auto low = static_cast<float>(range_.low);
    const float sign = isInverted_ ? -1.0F : 1.0F;
    const float base = isInverted_ ? 255.5F : 0.5F;
    auto* grey = static_cast<std::uint8_t*>(picture_->GetScalarPointer());
    for (std::size_t i = 0; i < pixels_.pixels.size(); ++i) {
        const float value = (pixels_.pixels[i] - low) * gain;
        const float bounded = value > 0.0F ? (value < 255.0F ? value : 255.0F) : 0.0F;   // NaN shows as the darkest
        grey[i] = static_cast<std::uint8_t>(base + sign * bounded);
    }
    picture_->Modified();
    picture_->GetPointData()->GetScalars()->Modified();
    return picture_;
}

FrameQuad::FrameQuad()
{
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    cells->InsertNextCell(4, corners);
    rectangle_->SetPolys(cells);
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    for (const auto& [s, t] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
        coordinates->InsertNextTuple2(s, t);
    }
    rectangle_->GetPointData()->SetTCoords(coordinates);

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(rectangle_);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->ForceOpaqueOn();
    actor_->PickableOff();
    actor_->VisibilityOff();
    texture_->RepeatOff();
    texture_->EdgeClampOn();   // else the opposite border shines through at the edge
    texture_->SetColorModeToDirectScalars();
}

void FrameQuad::show(const GreyFrame& frame, Interpolation interpolation, double devicePxPerImagePx)
{
    if (frame.width() == 0 || frame.height() == 0) {
        actor_->VisibilityOff();
        return;
    }
    texture_->SetInputData(frame.picture());
    texture_->SetInterpolate(interpolation == Interpolation::Smooth);
    texture_->SetMipmap(interpolation == Interpolation::Smooth && devicePxPerImagePx < 0.9);   // else it would flicker
    actor_->SetTexture(texture_);
    actor_->VisibilityOn();
    if (width_ == frame.width() && height_ == frame.height()) {
        return;
    }
    width_ = frame.width();
    height_ = frame.height();
    const double right = width_ - 0.5;
    const double bottom = height_ - 0.5;
    vtkNew<vtkPoints> points;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}) {
        points->InsertNextPoint(u, v, 0.0);
    }
    rectangle_->SetPoints(points);
}

void showImagePlane(vtkCamera& camera, const ViewRect& rect)
{
    const double u = 0.5 * (rect.left + rect.right);
    const double v = 0.5 * (rect.top + rect.bottom);
    camera.ParallelProjectionOn();
    camera.SetFocalPoint(u, v, 0.0);
    camera.SetPosition(u, v, -100.0);
    camera.SetViewUp(0.0, -1.0, 0.0);
    camera.SetParallelScale(0.5 * (rect.bottom - rect.top));
    camera.SetClippingRange(1.0, 200.0);
    camera.UseExplicitAspectRatioOn();
    camera.SetExplicitAspectRatio((rect.right - rect.left) / (rect.bottom - rect.top));
}

}   // namespace ui
