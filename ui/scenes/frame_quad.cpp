#include "ui/scenes/frame_quad.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

using Gray = core::Image2d<std::uint8_t>;

/// Averages each 2 × 2 block into one pixel; an odd last row or column counts twice.
Gray halved(const Gray& gray)
{
    Gray half((gray.width + 1) / 2, (gray.height + 1) / 2);
    auto mean = half.pixels.begin();
    for (int y = 0; y < gray.height; y += 2) {
        const int below = std::min(y + 1, gray.height - 1);
        for (int x = 0; x < gray.width; x += 2) {
            const int beside = std::min(x + 1, gray.width - 1);
            const int sum = gray.at(x, y) + gray.at(beside, y) + gray.at(x, below) + gray.at(beside, below);
            *mean++ = static_cast<std::uint8_t>((sum + 2) / 4);
        }
    }
    return half;
}

/// Returns the number of halvings after which a screen pixel covers at most two texture pixels; more would flicker.
int halvingsFor(double devicePxPerImagePx)
{
    constexpr int most = 6;
    return std::clamp(static_cast<int>(std::floor(-std::log2(devicePxPerImagePx))), 0, most);
}

/// Returns a texture size that is not a power of two, since OpenGL would compile a separate program for such sizes.
int textureSize(int sizePx)
{
    return std::has_single_bit(static_cast<unsigned>(sizePx)) ? sizePx + 1 : sizePx;
}

int halvedSize(int sizePx, int halvings)
{
    for (int i = 0; i < halvings; ++i) {
        sizePx = (sizePx + 1) / 2;
    }
    return sizePx;
}

}   // namespace

FrameQuad::FrameQuad()
{
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = {0, 1, 2, 3};
    cells->InsertNextCell(4, corners);
    rectangle_->SetPolys(cells);
    coordinates_->SetNumberOfComponents(2);
    coordinates_->SetNumberOfTuples(4);
    rectangle_->GetPointData()->SetTCoords(coordinates_);

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(rectangle_);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->ForceOpaqueOn();
    actor_->PickableOff();
    actor_->VisibilityOff();
    texture_->RepeatOff();
    texture_->EdgeClampOn();   // keeps the opposite border from bleeding in at the edges
    texture_->SetColorModeToDirectScalars();
    texture_->InterpolateOn();
    texture_->SetInputData(image_);
}

void FrameQuad::show(const GrayFrame& frame, double devicePxPerImagePx)
{
    if (frame.width() == 0 || frame.height() == 0) {
        actor_->VisibilityOff();
        return;
    }
    const int halvings = halvingsFor(devicePxPerImagePx);
    const bool isNew = std::exchange(shownRevision_, frame.revision()) != frame.revision();
    if (std::exchange(shownHalvings_, halvings) != halvings || isNew) {
        uploadTexture(frame, halvings);
        fitRectangle(frame.width(), frame.height(), halvings);
    }
    actor_->SetTexture(texture_);
    actor_->VisibilityOn();
}

void FrameQuad::uploadTexture(const GrayFrame& frame, int halvings)
{
    Gray smaller;
    for (int i = 0; i < halvings; ++i) {
        smaller = halved(i == 0 ? frame.gray() : smaller);
    }
    const Gray& gray = halvings == 0 ? frame.gray() : smaller;
    const int width = textureSize(gray.width);
    const int height = textureSize(gray.height);
    image_->SetDimensions(width, height, 1);
    image_->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* texel = static_cast<std::uint8_t*>(image_->GetScalarPointer());
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* row = gray.pixels.data() + gray.index(0, std::min(y, gray.height - 1));
        texel = std::copy_n(row, gray.width, texel);
        texel = std::fill_n(texel, width - gray.width, row[gray.width - 1]);
    }
    image_->Modified();
}

void FrameQuad::fitRectangle(int width, int height, int halvings)
{
    const double right = width - 0.5;
    const double bottom = height - 0.5;
    const double step = std::exp2(halvings);
    const double s = width / step / textureSize(halvedSize(width, halvings));
    const double t = height / step / textureSize(halvedSize(height, halvings));
    struct Corner {
        double u, v, s, t;
    };
    vtkNew<vtkPoints> points;
    for (const Corner& corner : std::array<Corner, 4>{
             {{-0.5, -0.5, 0.0, 0.0}, {right, -0.5, s, 0.0}, {right, bottom, s, t}, {-0.5, bottom, 0.0, t}}}) {
        coordinates_->SetTuple2(points->InsertNextPoint(corner.u, corner.v, 0.0), corner.s, corner.t);
    }
    coordinates_->Modified();
    rectangle_->SetPoints(points);
}

}   // namespace angiopose::ui
