#pragma once

namespace angiopose::benchmarks {

/// Traces a simulated scan of 512 x 512 x 300 voxels and prints the time, the memory, and the response time to a stop
/// request.
void printLargeScan();

}   // namespace angiopose::benchmarks
