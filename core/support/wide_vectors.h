#pragma once

// A function marked so is compiled twice, for AVX2 and for any x86-64, and chosen at start: distributions build for the
// latter, where loops over floats run at half the speed. Neither fuses multiplications with additions, so the results
// are the same bits. Sanitizers cannot start such functions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ANGIOPOSE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define ANGIOPOSE_WIDE_VECTORS
#endif
