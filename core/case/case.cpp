#include "core/case/case.h"

namespace angiopose::core {

Result<RigidTransform> startPoseOf(const Case& theCase)
{
    return startPoseOf(theCase.shown(), theCase.vessels);
}

}   // namespace angiopose::core
