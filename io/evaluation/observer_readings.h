#pragma once

#include "core/evaluation/own/observer_agreement.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// Reads the finished trials from a log of blind trials (observer_log.h). Fails if the file is not such a log or was
/// created by a version that did not store the centroid of the tree.
core::Result<std::vector<core::ObserverReading>> readObserverReadings(const std::string& path);

}   // namespace angiopose::io
