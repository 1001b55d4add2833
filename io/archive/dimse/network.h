#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

#include <functional>

namespace angiopose::io {

/// Asked about once a second while nothing comes, and for every piece that goes or comes: true to end it.
using StopQuestion = std::function<bool()>;

/// Whether there was a sign of life elsewhere since last asked, which allows more time.
using LifeQuestion = std::function<bool()>;

/// How long until a connection must be there.
inline constexpr int connectSeconds = 5;

/// Sets what DCMTK keeps for the whole process: silence, and bounds of its waits. `answerSeconds` at least.
void prepareNetwork(int answerSeconds);

/// Fails for a host that no resolver knows within `connectSeconds`.
core::Status resolveHost(const ArchiveNode& node, const StopQuestion& isStopWished);

}   // namespace angiopose::io
