#pragma once

namespace angiopose::test {

/// The address sanitizer takes the signals of faults for itself, and time.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

/// How long a test waits for work in another thread before it counts as lost, ms.
inline constexpr int patienceMs = isSanitized ? 300000 : 60000;

}   // namespace angiopose::test
