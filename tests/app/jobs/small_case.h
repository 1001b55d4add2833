#pragma once

#include "core/registration/registration.h"
#include "core/simulation/simulated_case.h"

namespace angiopose::test {

/// A small simulated case, quick to register and to trace.
inline core::SimulatedCase smallCase()
{
    core::TreeOptions tree;
    tree.branchCount = 8;
    core::DsaOptions dsa;
    dsa.width = 256;
    dsa.height = 256;
    dsa.frameCount = 3;
    dsa.missingBranchShare = 0.0;
    dsa.extraBranchShare = 0.0;
    return core::simulateCase(11, tree, dsa);
}

inline core::RegistrationInput inputOf(const core::SimulatedCase& simulated)
{
    return {simulated.tree, simulated.trueTarget, simulated.camera, simulated.initialCameraFromPatient, {}, {}};
}

}   // namespace angiopose::test
