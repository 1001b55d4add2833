#include "core/case/case.h"

namespace angiopose::core {

Result<RigidTransform> startPoseOf(const Case& session)
{
    return startPoseOf(session.shown(), session.vessels);
}

}   // namespace angiopose::core
