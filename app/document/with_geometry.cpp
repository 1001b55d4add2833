#include "app/document/with_geometry.h"

namespace angiopose::app {
namespace {

bool isSamePose(const core::RigidTransform& a, const core::RigidTransform& b)
{
    return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < 1e-9;
}

}   // namespace

core::Case replaceGeometry(core::Case base, const core::CArm& cArm)
{
    const auto before = core::initialPoseOf(base);
    core::View& view = base.shown();
    view.geometry.cArm = cArm;
    const bool wasAtStart = !before || isSamePose(before.value(), view.cameraFromPatient);
    if (wasAtStart) {
        if (const auto start = core::initialPoseOf(base)) {
            view.cameraFromPatient = start.value();
        }
    }
    core::discardResults(view);
    return base;
}

}   // namespace angiopose::app
