#include "app/help/fit_examples.h"

#include "app/texts/overlay_image.h"
#include "core/geometry/pose_offset.h"
#include "core/simulation/simulated_case.h"
#include "io/image_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace angiopose::app {
namespace {

constexpr std::uint64_t exampleSeed = 11;
constexpr int widthPx = 512;

core::DsaOptions imageOf(ui::FitExample example)
{
    core::DsaOptions options;
    options.frameCount = 4;
    options.missingBranchShare = example == ui::FitExample::Unopacified ? 0.3 : 0.0;
    options.nonRigidStdMm = example == ui::FitExample::Deformed ? 1.2 : 0.0;
    options.extraBranchShare = 0.0;
    options.catheterProbability = 0.0;
    options.shutterProbability = 0.0;
    return options;
}

/// Returns the pose error of the example relative to the ground truth.
core::PoseOffset poseErrorOf(ui::FitExample example)
{
    core::PoseOffset error;
    switch (example) {
        case ui::FitExample::Shifted:
            error.rightMm = 6.0;
            error.upMm = 3.0;
            break;
        case ui::FitExample::Turned:
            error.rollDeg = 9.0;
            break;
        case ui::FitExample::Tilted:
            error.laoRaoDeg = 16.0;
            break;
        case ui::FitExample::Right:
        case ui::FitExample::Unopacified:
        case ui::FitExample::Deformed:
            break;
    }
    return error;
}

core::Case caseOf(const core::SimulatedCase& simulated, ui::FitExample example)
{
    core::Case session;
    session.vessels.tree = std::make_shared<const core::VesselTree>(simulated.tree);
    core::Angiogram single = simulated.angiogram;
    single.frames = {simulated.angiogram.frames[static_cast<std::size_t>(simulated.angiogram.suggestedFrame)]};
    core::View& view = session.shown();
    view.angiogram = std::make_shared<const core::Angiogram>(std::move(single));
    view.geometry = {simulated.angiogram.cArm, simulated.camera};
    view.cameraFromPatient = core::applyOffset(simulated.trueCameraFromPatient, poseErrorOf(example),
                                               core::centroidInPatient(simulated.tree), simulated.camera);
    return session;
}

}   // namespace

core::Result<QString> fitExampleImage(ui::FitExample example)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
                      QStringLiteral("/fit-pictures-" ANGIOPOSE_VERSION));
    const QString path = folder.filePath(QStringLiteral("%1.png").arg(static_cast<int>(example)));
    if (QFileInfo::exists(path)) {
        return path;
    }
    folder.mkpath(QStringLiteral("."));
    const core::SimulatedCase simulated = core::simulateCase(exampleSeed, {}, imageOf(example));
    const auto picture = drawThumbnail(caseOf(simulated, example), widthPx, &simulated.trueTarget);
    if (!picture) {
        return picture.error();
    }
    if (const auto written = io::writePng(picture.value(), path.toStdString()); !written) {
        return written.error();
    }
    return path;
}

}   // namespace angiopose::app
