#pragma once

namespace angiopose::io {

/// Stops VTK, ITK, DCMTK, nifti_clib and libtiff from printing to the terminal; relevant problems are returned as
/// messages. Cheap to call repeatedly.
void quietLibraries();

}   // namespace angiopose::io