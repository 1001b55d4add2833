#pragma once

#include "ui/scenes/canvas.h"
#include "ui/scenes/row_bands.h"
#include "ui/scenes/stroke_mesh.h"

namespace angiopose::ui {

/// Blends the triangles of a mesh onto the canvas in their order. `topOfMesh` is the mesh's y at the canvas's upper
/// edge (the canvas's height if both cover the same area). Triangles that share an edge neither overlap nor leave gaps:
/// a pixel belongs to the triangle that contains its center.
void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas);

/// Does the same for some rows of the canvas only.
void fillStrokes(const StrokeMesh& mesh, double topOfMesh, Canvas canvas, const Rows& rows);

}   // namespace angiopose::ui