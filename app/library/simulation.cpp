#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/simulation/simulated_case.h"

namespace angiopose {

SimulatedCase simulateCase(std::uint64_t seed, const SimulationOptions& options)
{
    core::TreeOptions tree;
    tree.branchCount = options.branchCount;
    core::DsaOptions dsa;
    dsa.nonRigidStdMm = options.nonRigidStdMm;
    dsa.missingBranchShare = options.missingBranchShare;
    dsa.extraBranchShare = options.extraBranchShare;
    dsa.frameCount = options.frameCount;
    if (const auto problem = core::findProblem(tree, dsa)) {
        library::throwError(*problem);
    }
    core::SimulatedCase simulated = core::simulateCase(seed, tree, dsa);

    auto content = std::make_unique<Case::Content>();
    content->values.title = "Simulated case, seed " + std::to_string(seed);
    content->values.vessels.tree = std::make_shared<const core::VesselTree>(std::move(simulated.tree));
    library::addAngiogram(content->values, std::make_shared<const core::Angiogram>(std::move(simulated.angiogram)));
    Case session(std::move(content));
    session.setInitialPose(library::toPublic(simulated.initialCameraFromPatient));
    return {std::move(session), library::toPublic(simulated.trueCameraFromPatient),
            library::toPublic(simulated.trueTarget), std::move(simulated.missingBranchIds)};
}

}   // namespace angiopose
