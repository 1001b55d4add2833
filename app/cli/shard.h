#pragma once

#include "core/evaluation/run_experiment.h"
#include "core/support/result.h"

#include <string>

namespace angiopose::app {

/// Parses "I/N": part I (from 1) of N.
core::Result<core::Shard> parseShard(const std::string& text);

}   // namespace angiopose::app
