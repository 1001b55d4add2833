#include "app/files/sample_case.h"

#include "core/case/case.h"
#include "core/simulation/simulated_case.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/vessel_tree_file.h"

#include <QDir>
#include <QStandardPaths>

namespace angiopose::app {
namespace {

constexpr std::uint64_t sampleSeed = 7;

core::Case caseOf(const core::SimulatedCase& simulated, const std::string& treePath, const std::string& imagePath)
{
    core::Case result;
    result.title = "Sample case (simulated)";
    result.vessels.tree = std::make_shared<core::VesselTree>(simulated.tree);
    result.vessels.file.path = treePath;
    core::View& view = result.shown();
    view.angiogram = std::make_shared<core::Angiogram>(simulated.angiogram);
    view.imageFile.path = imagePath;
    view.frame = simulated.angiogram.suggestedFrame;
    view.geometry.cArm = simulated.angiogram.cArm;
    view.initialCameraFromPatient = simulated.initialCameraFromPatient;
    view.cameraFromPatient = simulated.initialCameraFromPatient;
    return result;
}

}   // namespace

core::Result<QString> writeSampleCase()
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) +
                      QStringLiteral("/sample"));
    folder.mkpath(QStringLiteral("."));
    const QString casePath = folder.filePath(QStringLiteral("sample.angiopose"));
    const std::string treePath = folder.filePath(QStringLiteral("tree.vtp")).toStdString();
    const std::string imagePath = folder.filePath(QStringLiteral("run.dcm")).toStdString();
    const core::SimulatedCase simulated = core::simulateCase(sampleSeed);
    if (auto written = io::writeVesselTree(simulated.tree, treePath); !written) {
        return written.error();
    }
    if (auto written = io::writeAngiogram(simulated.angiogram, imagePath); !written) {
        return written.error();
    }
    if (auto written = io::saveCase(caseOf(simulated, treePath, imagePath), casePath.toStdString()); !written) {
        return written.error();
    }
    return casePath;
}

}   // namespace angiopose::app
