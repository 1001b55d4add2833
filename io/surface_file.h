#pragma once

#include "core/support/result.h"
#include "core/vessel/surface_mesh.h"
#include "io/support/read_observer.h"

#include <string>
#include <vector>

namespace angiopose::io {

struct LoadedSurface {
    core::SurfaceMesh mesh;   ///< welded, patient LPS
    core::Messages warnings;   ///< holes, a suspicious size
    bool isUnitStated = false;   ///< by the file
    double acrossMm = 0.0;   ///< diagonal of the box around it
};

/// False where vessels are hardly of that size: the unit of the file may be another.
bool isUsualSize(double acrossMm);

/// A triangle surface from VTP, legacy VTK (poly-data, unstructured grid), STL, PLY or OBJ; lengths times `unitMm`,
/// or 0 for the unit that the file states, else mm. RAS files that say so are turned. Fails with file, problem and
/// remedy, also when there is no triangle.
core::Result<LoadedSurface> readSurface(const std::string& path, double unitMm = 0.0, const ReadObserver& observe = {});

/// Writes binary STL, patient LPS.
core::Status writeSurface(const core::SurfaceMesh& mesh, const std::string& path);

}   // namespace angiopose::io