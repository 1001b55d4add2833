#pragma once

#include "core/registration/pose_snapshot.h"

#include <QString>

namespace angiopose::app {

/// Returns the login name of the user.
QString observerName();

/// Creates the snapshot of a completed registration, named after its method and the time.
core::PoseSnapshot snapshotOfRun(const core::RegistrationResult& result, int frame);

}   // namespace angiopose::app
