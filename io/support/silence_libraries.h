#pragma once

namespace angiopose::io {

/// Prevents VTK, ITK, DCMTK, nifti_clib and libtiff from printing to the terminal; readers return relevant problems as
/// messages. Cheap to call repeatedly.
void silenceLibraries();

}   // namespace angiopose::io
