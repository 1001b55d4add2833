#pragma once

#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct LoadedSurface {
    core::SurfaceMesh mesh;   ///< vertices merged, patient LPS
    core::Messages warnings;   ///< about holes and an implausible size
    bool isUnitStated = false;   ///< the file states its unit
    double acrossMm = 0.0;   ///< diagonal of the bounding box
};

/// Returns false if the size is implausible for vessels: the unit of the file may be another.
bool isUsualSize(double acrossMm);

/// Reads a triangle surface from VTP, legacy VTK (poly-data, unstructured grid), STL, PLY or OBJ. `unitMm` is the
/// length of one unit; 0: the unit that the file states, otherwise mm. Converts files that state RAS. Fails with file,
/// problem and remedy, also if there is no triangle.
core::Result<LoadedSurface> readSurface(const std::string& path, double unitMm = 0.0, const ReadObserver& observe = {});

/// Writes binary STL, patient LPS.
core::Status writeSurface(const core::SurfaceMesh& mesh, const std::string& path);

}   // namespace angiopose::io