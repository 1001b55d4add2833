#pragma once

#if __cplusplus < 202002L
#error \
    "AngioPose needs C++20: compile with -std=c++20, or link the CMake target AngioPose::AngioPose, which requires it."
#endif

/// Marks the exported symbols of the library; all others are hidden.
#if defined(ANGIOPOSE_BUILDS_LIBRARY)
#define ANGIOPOSE_EXPORT __attribute__((visibility("default")))
#else
#define ANGIOPOSE_EXPORT
#endif
