#pragma once

namespace angiopose::core {

/// Decision of a progress observer about the operation it observes.
enum class Verdict { Continue, Stop };

}   // namespace angiopose::core
