#pragma once

/// Marks what the library shows; everything else stays inside it.
#if defined(ANGIOPOSE_BUILDS_LIBRARY)
#define ANGIOPOSE_EXPORT __attribute__((visibility("default")))
#else
#define ANGIOPOSE_EXPORT
#endif
