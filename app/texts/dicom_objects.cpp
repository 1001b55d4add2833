#include "app/texts/dicom_objects.h"

#include "app/messages/messages.h"
#include "app/texts/dicom_contents.h"
#include "core/imaging/mark_ball.h"
#include "io/dicom/objects/case_measurements.h"
#include "io/dicom/objects/encapsulated_pdf.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/scan_reference.h"

#include <algorithm>

namespace angiopose::app {
namespace {

/// Returns the frame of reference of the scan. The vessels may be traced in the same file or come from another one.
std::string scanFrame(const DicomExportInput& exportInput)
{
    return io::scanFrameOfReference(exportInput.scan.source, exportInput.session.vessels.file.sha256);
}

core::Result<std::string> reportObject(const DicomExportInput& exportInput)
{
    if (!exportInput.wanted.report) {
        return core::Error(messages::dicomNoReport());
    }
    const auto pdf = exportInput.wanted.report();
    // The report contains titles and file names, which may identify the patient even if the identity is hidden.
    return pdf ? io::encapsulatedPdf(pdf.value(), exportInput.session.title, io::BurnedInIdentity::Possible,
                                     exportInput.angiogram, exportInput.origin)
               : core::Result<std::string>(pdf.error());
}

core::Result<std::string> registrationObject(const DicomExportInput& exportInput, core::Messages& notes)
{
    const core::View& view = exportInput.session.shown();
    const auto camera = core::cameraOf(view);
    if (!camera) {
        return camera.error();
    }
    notes.push_back(messages::dicomRigidOnly());
    const io::CArmRegistration registration{view.cameraFromPatient, camera.value(), scanFrame(exportInput),
                                            io::cameraFrameOfReference(exportInput.angiogram, exportInput.origin),
                                            view.result ? view.result->method : std::string()};
    return io::spatialRegistration(registration, exportInput.angiogram, exportInput.origin);
}

/// Draws the tree as tubes with its radii into a mask on the voxel grid of the scan.
core::VoxelMask rasterizeTree(const core::VesselTree& tree, const core::VolumeGeometry& grid)
{
    core::VoxelMask mask(grid);
    const double step = 0.5 * grid.spacingMm.minCoeff();
    for (const core::VesselBranch& branch : core::resampled(tree, step).branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const double radius = branch.radiusMm.empty() ? 0.0 : branch.radiusMm[i];
            core::markBall(branch.pointsInPatient[i], std::max(radius, step), mask);
        }
    }
    return mask;
}

core::Result<std::string> segmentationObject(const DicomExportInput& exportInput, core::Messages& notes)
{
    const core::Vessels& vessels = exportInput.session.vessels;
    if (!vessels.lumen && !vessels.scan) {
        return core::Error(messages::dicomNoScan());
    }
    auto made =
        vessels.lumen
            ? io::vesselSegmentation(*vessels.lumen,
                                     vessels.isLumenEdited ? "Lumen traced in the scan and edited by hand"
                                                           : "Lumen that the vessel tree was traced from",
                                     exportInput.scan, exportInput.origin)
            : io::vesselSegmentation(rasterizeTree(*vessels.tree, vessels.scan->geometry),
                                     "Centrelines drawn as tubes of their radii", exportInput.scan, exportInput.origin);
    if (made && !exportInput.scan.source.isDicom) {
        notes.push_back(messages::dicomNoScanStudy());
    }
    return made;
}

}   // namespace

io::ScanReference scanReferenceOf(const core::Vessels& vessels)
{
    const bool isApart = !vessels.scanFile.path.empty();
    const bool isInFile = vessels.input.kind == core::VesselInputKind::Volume ||
                          vessels.input.kind == core::VesselInputKind::Segmentation;
    if (!isApart && !isInFile) {
        return {};
    }
    auto found = isApart ? io::readScanReference(vessels.scanFile.path, vessels.scanSeriesId)
                         : io::readScanReference(vessels.file.path, vessels.input.seriesId);
    return found ? std::move(found).value() : io::ScanReference{};
}

core::Result<std::string> dicomObject(DicomKind kind, const DicomExportInput& exportInput, core::Messages& notes)
{
    switch (kind) {
        case DicomKind::Picture:
            return makeSecondaryCapture(exportInput);
        case DicomKind::Run:
            return makeCineCapture(exportInput);
        case DicomKind::Report:
            return reportObject(exportInput);
        case DicomKind::State:
            return makePresentationState(exportInput, notes);
        case DicomKind::Registration:
            return registrationObject(exportInput, notes);
        case DicomKind::Segmentation:
            return segmentationObject(exportInput, notes);
        case DicomKind::Measurements:
            break;
    }
    return io::measurementReport({io::reportGroups(exportInput.session), scanFrame(exportInput)}, exportInput.angiogram,
                                 exportInput.origin);
}

}   // namespace angiopose::app
