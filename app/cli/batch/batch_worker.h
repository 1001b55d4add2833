#pragma once

#include <string>
#include <vector>

namespace angiopose::app {

/// What a worker finds in its environment: for libraries that know their number of threads by it, and for the
/// allocator, which would give memory back to the system after each case and take it again.
std::vector<std::string> workerEnvironment(int threads);

}   // namespace angiopose::app
