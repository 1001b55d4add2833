#pragma once

namespace angiopose::core {

/// What an observer of long work wants next.
enum class Verdict { Continue, Stop };

}   // namespace angiopose::core