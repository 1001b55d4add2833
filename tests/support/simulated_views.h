#pragma once

#include "core/case/case.h"
#include "core/simulation/simulated_case.h"

#include <memory>

namespace angiopose::test {

/// The view of a simulated case: the true geometry, with the pose that a header would give.
inline core::View viewOf(const core::SimulatedCase& simulated)
{
    core::View view;
    view.angiogram = std::make_shared<const core::Angiogram>(simulated.angiogram);
    view.frame = simulated.angiogram.suggestedFrame;
    view.geometry.cArm = simulated.angiogram.cArm;
    view.geometry.cameraOverride = simulated.camera;
    view.initialCameraFromPatient = simulated.initialCameraFromPatient;
    view.cameraFromPatient = simulated.initialCameraFromPatient;
    view.target.centerline = std::make_shared<const core::Centerline2d>(simulated.trueTarget);
    return view;
}

inline core::Case caseOf(const core::SimulatedCase& simulated)
{
    core::Case values;
    values.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
    values.views = {viewOf(simulated)};
    return values;
}

/// A small tree in two views with the true geometry between them; the pose is off by 4 mm.
inline core::Case twoViewCase()
{
    core::TreeOptions tree;
    tree.branchCount = 10;
    core::DsaOptions dsa;
    dsa.width = dsa.height = 256;
    dsa.frameCount = 3;
    dsa.missingBranchShare = dsa.extraBranchShare = 0.0;
    core::Case values;
    for (const std::uint64_t seed : {1U, 4U}) {
        const core::SimulatedCase simulated = core::simulateView(5, seed, tree, dsa);
        values.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
        core::View view = viewOf(simulated);
        view.geometry.cArm = {};   // the initial poses alone define the geometry between the views
        view.initialCameraFromPatient = view.cameraFromPatient = simulated.trueCameraFromPatient;
        view.cameraFromPatient.translation += Eigen::Vector3d(4.0, 0.0, 0.0);
        values.views.push_back(view);
    }
    values.views.erase(values.views.begin());   // the empty view of a new case
    return values;
}

}   // namespace angiopose::test
