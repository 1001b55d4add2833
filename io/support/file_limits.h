#pragma once

namespace angiopose::io {

/// Turns writing beyond the file-size limit (`ulimit -f`) into an ordinary error instead of a signal that ends the
/// program silently. To be called at program start.
void reportFileSizeLimit();

}   // namespace angiopose::io
