#pragma once

#include "core/support/result.h"
#include "io/support/read_observer.h"
#include "io/vessel/vtk_lines.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// Legacy VTK (ASCII or binary, up to format 5.1), poly-data or unstructured grid, read by VTK in a process of its own.
/// `content` is the file's.
core::Result<VtkLines> readLegacyVtk(std::string_view content, const std::string& path,
                                     const ReadObserver& observe = {});

/// VTK XML, PolyData (.vtp) or UnstructuredGrid (.vtu), likewise.
core::Result<VtkLines> readXmlVtk(std::string_view content, const std::string& path, const ReadObserver& observe = {});

/// A surface in PLY, likewise; points come in single precision.
core::Result<VtkLines> readPly(const std::string& path, const ReadObserver& observe = {});

}   // namespace angiopose::io
