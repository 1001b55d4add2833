#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/vessel/vtk_lines.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Reads a legacy VTK file (ASCII or binary, up to format 5.1; PolyData or UnstructuredGrid) through VTK in a separate
/// process. `content` holds all bytes of the file.
core::Result<VtkLines> readLegacyVtk(std::string_view content, const std::string& path,
                                     const ReadObserver& observe = {});

/// Reads a VTK XML file, PolyData (.vtp) or UnstructuredGrid (.vtu), through VTK in a separate process.
core::Result<VtkLines> readXmlVtk(std::string_view content, const std::string& path, const ReadObserver& observe = {});

/// Reads a PLY surface through VTK in a separate process; points have single precision.
core::Result<VtkLines> readPly(const std::string& path, const ReadObserver& observe = {});

}   // namespace angiopose::io
