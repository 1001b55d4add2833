#pragma once

#include <string>
#include <vector>

namespace angiopose::app {

/// Returns the environment of a worker: the thread count for libraries that read it from a variable, and allocator
/// settings that retain memory between cases instead of returning it to the system.
std::vector<std::string> workerEnvironment(int threads);

}   // namespace angiopose::app
