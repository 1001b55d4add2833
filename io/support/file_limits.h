#pragma once

namespace angiopose::io {

/// Makes writing beyond the file-size limit (`ulimit -f`) an ordinary error instead of a signal that silently
/// terminates the program. Must be called at program start.
void reportFileSizeLimit();

}   // namespace angiopose::io
