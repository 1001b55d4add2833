#pragma once

#include "core/case/initial_pose.h"
#include "core/case/vessels.h"
#include "core/case/view.h"
#include "core/registration/registration.h"

#include <cstddef>
#include <string>
#include <vector>

namespace angiopose::core {

/// The document of a session: everything the user edits. It is saved and loaded as a whole and is small enough to copy
/// for undo and for worker threads.
struct Case {
    std::string title;
    Vessels vessels;
    std::vector<View> views = std::vector<View>(1);   ///< angiograms; at least one, empty until loaded
    std::size_t shownView = 0;   ///< index into `views` of the view to which the window and single-view commands refer
    RegistrationOptions options;
    std::string extraKeys;   ///< JSON object with the case-file keys that this version does not recognize

    const View& shown() const { return views[shownView]; }
    View& shown() { return views[shownView]; }
};

/// Returns the initial pose of the shown view.
Result<RigidTransform> initialPoseOf(const Case& session);

}   // namespace angiopose::core
