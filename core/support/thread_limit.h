#pragma once

namespace angiopose::core {

/// How many threads the work of this process may use at once: as many as the processor has, or fewer where that was
/// limited. Changes times only, never numbers.
int usableThreads();

/// For a process that shares the machine with others of its kind; also for the libraries of this layer. Before any work
/// begins.
void limitThreads(int threads);

}   // namespace angiopose::core
