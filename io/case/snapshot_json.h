#pragma once

#include "core/registration/pose_snapshot.h"
#include "core/support/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

/// The array under `snapshots` of a case file.
std::string snapshotsJson(const std::vector<core::PoseSnapshot>& snapshots);

/// The snapshots of such an array (one that follows the schema), numbered from 1; adds to `problems` what makes no
/// sense.
std::vector<core::PoseSnapshot> snapshotsFromJson(std::string_view json, core::Messages& problems);

}   // namespace angiopose::io