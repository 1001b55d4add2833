#pragma once

namespace angiopose::test {

/// The address sanitizer handles fault signals itself and takes more time.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool isSanitized = true;
#else
inline constexpr bool isSanitized = false;
#endif

/// Time that a test waits for work in another thread before it fails, ms.
inline constexpr int patienceMs = isSanitized ? 300000 : 60000;

}   // namespace angiopose::test
