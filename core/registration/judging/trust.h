#pragma once

#include "core/registration/judging/followed_vessels.h"

namespace angiopose::core {

/// What trust is judged by; metrics, branches, uncertainty and alternatives of `result` are filled in.
struct Evidence {
    const RegistrationProblem& problem;
    const ProjectedTree& projected;
    const RegistrationResult& result;
    const TargetLines& target;
    double agreement = 1.0;   ///< both ways, 0…1, see AgreementScore
    bool isFilledInParts = false;   ///< all of this is about the filled parts of the tree
    int filledForks = 0;   ///< places where three filled pieces or more meet; of a tree filled in parts
    double settlingMm = 0.0;   ///< see settlingShiftMm
    double expectedErrorMm = 0.0;   ///< see expectedShiftMm
    double rivalMm = 0.0;   ///< how far the farthest alternative puts the tree elsewhere
};

struct Trust {
    bool isTrustworthy = true;
    Messages warnings;   ///< reasons against trust first, then what one view cannot tell
};

/// Says in a clinician's words why a pose may be wrong; silent when nothing speaks against it.
Trust judgeTrust(const Evidence& evidence);

}   // namespace angiopose::core