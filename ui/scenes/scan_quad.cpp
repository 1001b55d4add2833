#include "ui/scenes/scan_quad.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>

namespace angiopose::ui {

ScanQuad::ScanQuad()
{
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    cells->InsertNextCell(4, corners);
    rectangle_->SetPolys(cells);
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(2);
    for (const auto& [s, t] : std::array<std::array<double, 2>, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}) {
        coordinates->InsertNextTuple2(s, t);
    }
    rectangle_->GetPointData()->SetTCoords(coordinates);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(rectangle_);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->ForceOpaqueOn();   // keeps blending on, because VTK would sort translucent actors in a separate pass
    actor_->PickableOff();
    actor_->VisibilityOff();
    texture_->RepeatOff();
    texture_->EdgeClampOn();
    texture_->SetColorModeToDirectScalars();
    texture_->SetPremultipliedAlpha(true);
    texture_->InterpolateOn();
    texture_->SetInputData(image_);
}

void ScanQuad::show(const ScanRendering& image)
{
    const core::ParallelProjection& projection = image.projection;
    if (image.pixels.isEmpty()) {
        actor_->VisibilityOff();
        return;
    }
    image_->SetDimensions(image.pixels.width, image.pixels.height, 1);
    image_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    std::copy_n(image.pixels.pixels.data()->data(), 4 * image.pixels.pixels.size(),
                static_cast<std::uint8_t*>(image_->GetScalarPointer()));
    image_->Modified();
    const Eigen::Vector3d right = 0.5 * projection.width * projection.mmPerPx * projection.right;
    const Eigen::Vector3d up = 0.5 * projection.height * projection.mmPerPx * projection.up;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Eigen::Vector3d& offset : {Eigen::Vector3d(-right - up), Eigen::Vector3d(right - up),
                                          Eigen::Vector3d(right + up), Eigen::Vector3d(up - right)}) {
        points->InsertNextPoint((projection.centerInPatient + offset).eval().data());
    }
    rectangle_->SetPoints(points);
    actor_->SetTexture(texture_);
    actor_->VisibilityOn();
}

}   // namespace angiopose::ui
