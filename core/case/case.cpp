#include "core/case/case.h"

namespace angiopose::core {

Result<RigidTransform> initialPoseOf(const Case& session)
{
    return initialPoseOf(session.shown(), session.vessels);
}

}   // namespace angiopose::core
