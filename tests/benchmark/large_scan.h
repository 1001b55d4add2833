#pragma once

namespace angiopose::benchmarks {

/// Traces a simulated scan of 512 x 512 x 300 voxels: its time and memory, and how soon a stop is answered.
void printLargeScan();

}   // namespace angiopose::benchmarks