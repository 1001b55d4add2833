#pragma once

namespace angiopose::io {

/// Writing beyond the limit for the size of files (`ulimit -f`) becomes an error like any other instead of a signal
/// that ends the program without a word. For the start of a program.
void reportFileSizeLimit();

}   // namespace angiopose::io
