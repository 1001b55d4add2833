#pragma once

namespace angiopose::core {

/// Decision of a progress observer about the operation it observes.
enum class ObserverDecision { Continue, Stop };

}   // namespace angiopose::core
