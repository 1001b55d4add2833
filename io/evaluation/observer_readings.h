#pragma once

#include "core/evaluation/own/observer_agreement.h"
#include "core/support/result.h"

#include <string>
#include <vector>

namespace angiopose::io {

/// The finished trials of a log of blind trials (observer_log.h). Fails where it is none, or was begun by a version
/// that did not keep the tree's centroid.
core::Result<std::vector<core::ObserverReading>> readObserverReadings(const std::string& path);

}   // namespace angiopose::io
