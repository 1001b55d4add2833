#pragma once

#include "core/evaluation/run_experiment.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::app {

/// The part of the work that "I/N" names, I from 1 to N.
core::Result<core::Shard> shardFrom(const std::string& text);

}   // namespace angiopose::app