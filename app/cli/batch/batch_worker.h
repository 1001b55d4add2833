#pragma once

#include <string>
#include <vector>

namespace angiopose::app {

/// Returns the environment of a worker: the number of threads for libraries that read it there, and allocator settings
/// that keep memory between cases instead of returning it to the system.
std::vector<std::string> workerEnvironment(int threads);

}   // namespace angiopose::app
