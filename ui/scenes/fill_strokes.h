#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

/// Blends the triangles of a mesh onto the canvas, in order. `topOfMesh` is the mesh's y coordinate at the upper edge
/// of the canvas (the canvas height if both cover the same area). A pixel belongs to the triangle that contains its
/// center; triangles that share an edge therefore neither overlap nor leave gaps.
void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas);

/// Blends only the triangles' pixels in the given rows of the canvas.
void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas, const Rows& rows);

}   // namespace angiopose::ui
