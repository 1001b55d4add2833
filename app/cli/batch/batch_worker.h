#pragma once

#include <string>
#include <vector>

namespace angiopose::app {

/// What runs in a worker of a batch, started by process `parent`: rows one after the other, as they come, on so many
/// threads. Ends with the other side. Its exit code.
int runBatchWorker(int parent, int threads);

/// What a worker finds in its environment: for libraries that know their number of threads by it, and for the
/// allocator, which would give memory back to the system after each case and take it again.
std::vector<std::string> workerEnvironment(int threads);

}   // namespace angiopose::app
