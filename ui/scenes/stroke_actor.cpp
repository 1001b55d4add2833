#include "ui/scenes/stroke_actor.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace angiopose::ui {
namespace {

template <class Array, class Value>
vtkSmartPointer<Array> arrayOf(const std::vector<Value>& values, int components)
{
    auto array = vtkSmartPointer<Array>::New();
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

}   // namespace

StrokeActor::StrokeActor()
{
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data_);
    mapper->ScalarVisibilityOn();
    mapper->SetScalarModeToUsePointData();
    actor_->SetMapper(mapper);
    actor_->PickableOff();
}

void StrokeActor::show(const StrokeMesh& mesh)
{
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf<vtkFloatArray>(mesh.points, 3));
    const auto triangleCount = static_cast<vtkIdType>(mesh.triangles.size()) / 3;
    vtkNew<vtkTypeInt32Array> offsets;
    offsets->SetNumberOfTuples(triangleCount + 1);
    for (vtkIdType i = 0; i <= triangleCount; ++i) {
        offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
    }
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(offsets, arrayOf<vtkTypeInt32Array>(mesh.triangles, 1));
    data_->SetPoints(points);
    data_->SetPolys(triangles);
    data_->GetPointData()->SetScalars(arrayOf<vtkUnsignedCharArray>(mesh.colors, 4));
    actor_->SetVisibility(triangleCount > 0);
}

}   // namespace angiopose::ui
