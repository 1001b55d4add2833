#pragma once

namespace angiopose::io {

/// Stops VTK, ITK, DCMTK, nifti_clib and libtiff from printing to the terminal: what matters comes back as a message.
/// Cheap to repeat.
void quietLibraries();

}   // namespace angiopose::io