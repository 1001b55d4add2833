#pragma once

namespace angiopose::core {

/// Decision of a progress observer.
enum class Verdict { Continue, Stop };

}   // namespace angiopose::core