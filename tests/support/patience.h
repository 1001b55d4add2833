#pragma once

namespace angiopose::test {

/// How long a test waits for work in another thread before it counts as lost, ms.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int patienceMs = 300000;
#else
inline constexpr int patienceMs = 60000;
#endif

}   // namespace angiopose::test
