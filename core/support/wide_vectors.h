#pragma once

// Compiles the marked function twice, for AVX2 and for baseline x86-64, and selects one at startup: distributions build
// for the baseline, with which loops over floats run at half the speed. Neither fuses multiplications with additions,
// so results are bitwise equal. Sanitizers cannot start such functions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ANGIOPOSE_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define ANGIOPOSE_WIDE_VECTORS
#endif
