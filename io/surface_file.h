#pragma once

#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct LoadedSurface {
    core::SurfaceMesh mesh;   ///< triangle mesh with merged vertices, patient LPS
    core::Messages warnings;   ///< warnings about holes and an implausible size
    bool isUnitStated = false;   ///< whether the file states its unit
    double extentMm = 0.0;   ///< diagonal of the bounding box, mm
};

/// Returns whether the size is plausible for vessels; if not, the file may use another unit.
bool isPlausibleSize(double extentMm);

/// Reads a triangle surface from VTP, legacy VTK (PolyData, UnstructuredGrid), STL, PLY or OBJ. `unitMm` is the length
/// of one unit; if 0, uses the unit that the file states, otherwise mm. Converts files that state RAS. Fails if the
/// file contains no triangles or cannot be read; the error names the file, the problem and the remedy.
core::Result<LoadedSurface> readSurface(const std::string& path, double unitMm = 0.0, const ReadObserver& observe = {});

/// Writes binary STL in patient LPS.
core::Status writeSurface(const core::SurfaceMesh& mesh, const std::string& path);

}   // namespace angiopose::io
