#pragma once

#include "core/registration/pose_snapshot.h"

#include <QString>

namespace angiopose::app {

/// Who sits here: the login name.
QString observerName();

/// What a run leaves behind, named after its method and the time.
core::PoseSnapshot snapshotOfRun(const core::RegistrationResult& result, int frame);

}   // namespace angiopose::app