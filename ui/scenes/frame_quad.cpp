#include "ui/scenes/frame_quad.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <utility>

namespace ui {

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
    texture_->InterpolateOn();
    texture_->SetInputData(picture_);
}

void FrameQuad::show(const GreyFrame& frame, double devicePxPerImagePx)
{
    if (frame.width() == 0 || frame.height() == 0) {
        actor_->VisibilityOff();
        return;
    }
    showPicture(frame);
    fitRectangle(frame.width(), frame.height());
    texture_->SetMipmap(devicePxPerImagePx < 0.9);   // else it would flicker
    actor_->SetTexture(texture_);
    actor_->VisibilityOn();
}

void FrameQuad::showPicture(const GreyFrame& frame)
{
    if (std::exchange(shownRevision_, frame.revision()) == frame.revision()) {
        return;
    }
    picture_->SetDimensions(frame.width(), frame.height(), 1);
    picture_->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::ranges::copy(frame.grey().pixels, static_cast<std::uint8_t*>(picture_->GetScalarPointer()));
    picture_->Modified();
}

void FrameQuad::fitRectangle(int width, int height)
{
    if (width_ == width && height_ == height) {
        return;
    }
    width_ = width;
    height_ = height;
    const double right = width_ - 0.5;
    const double bottom = height_ - 0.5;
    vtkNew<vtkPoints> points;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}) {
        points->InsertNextPoint(u, v, 0.0);
    }
    rectangle_->SetPoints(points);
}

}   // namespace ui
