#include "app/cli/simulated_files.h"

#include "app/messages/messages.h"
#include "core/case/case.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/centerline2d_file.h"
#include "io/messages/messages.h"
#include "io/pose_file.h"
#include "io/support/case_lock.h"
#include "io/vessel_tree_file.h"

#include <filesystem>
#include <memory>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

core::Case caseOf(const core::SimulatedCase& simulated, const fs::path& folder, const std::string& title,
                  SimulatedStart start)
{
    core::Case session;
    session.title = title;
    session.vessels.file.path = (folder / "tree.vtp").string();
    session.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
    core::View& view = session.shown();
    view.imageFile.path = (folder / "angiogram.dcm").string();
    view.angiogram = std::make_shared<const core::Angiogram>(simulated.angiogram);
    view.frame = simulated.angiogram.suggestedFrame;
    view.geometry.cArm = simulated.angiogram.cArm;
    if (start == SimulatedStart::Written) {
        view.initialCameraFromPatient = simulated.initialCameraFromPatient;
    }
    view.cameraFromPatient = simulated.initialCameraFromPatient;
    return session;
}

core::Status writeTruth(const core::SimulatedCase& simulated, const fs::path& folder)
{
    if (auto status = io::writeCenterline2d(simulated.trueTarget, (folder / "true-centreline.csv").string()); !status) {
        return status;
    }
    if (auto status = io::writePose(simulated.trueCameraFromPatient, (folder / "true-pose.json").string()); !status) {
        return status;
    }
    const fs::path deformed = folder / "true-vessels.vtp";
    if (simulated.deformedTree) {
        return io::writeVesselTree(*simulated.deformedTree, deformed.string());
    }
    std::error_code failure;
    fs::remove(deformed, failure);   // left over from another case in this folder
    return core::Done{};
}

}   // namespace

core::Status writeSimulatedCase(const core::SimulatedCase& simulated, const std::string& title,
                                const std::string& folderPath, SimulatedStart start)
{
    const fs::path folder(folderPath);
    const fs::path absolute = fs::absolute(folder);
    const std::string casePath = (absolute / "case.angiopose").string();
    if (const auto holder = io::holderOf(casePath)) {   // overwriting would remove the inputs of the case open there
        return core::Error(io::messages::caseOpenElsewhere(holder->process, holder->machine).about(casePath));
    }
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error(messages::folderNotMade(folder.string(), failure.message()));
    }
    if (auto status = io::writeVesselTree(simulated.tree, (folder / "tree.vtp").string()); !status) {
        return status;
    }
    if (auto status = io::writeAngiogram(simulated.angiogram, (folder / "angiogram.dcm").string()); !status) {
        return status;
    }
    if (auto status = writeTruth(simulated, folder); !status) {
        return status;
    }
    return io::saveCase(caseOf(simulated, absolute, title, start), casePath);
}

}   // namespace angiopose::app
