#pragma once

namespace core {

/// What an observer of long work wants next.
enum class Verdict { Continue, Stop };

}   // namespace core
