#include "app/texts/dicom_objects.h"

#include "app/messages/messages.h"
#include "app/texts/movie_steps.h"
#include "core/imaging/mark_ball.h"
#include "core/measuring/measure_image.h"
#include "core/tracing/angiogram/frame/burned_in_text.h"
#include "io/dicom/objects/case_measurements.h"
#include "io/dicom/objects/encapsulated_pdf.h"
#include "io/dicom/objects/presentation_state.h"
#include "io/dicom/objects/secondary_capture.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/scan_reference.h"
#include "ui/scenes/projected_tree.h"

#include <algorithm>

namespace angiopose::app {
namespace {

/// Returns the frame of reference of the scan, in which the vessels may have been traced or come from another file.
std::string scanFrame(const DicomExportInput& exportInput)
{
    return io::scanFrameOfReference(exportInput.scan.source, exportInput.session.vessels.file.sha256);
}

core::Result<std::string> reportObject(const DicomExportInput& exportInput)
{
    if (!exportInput.dicomExport.report) {
        return core::Error(messages::dicomNoReport());
    }
    const auto pdf = exportInput.dicomExport.report();
    // The report contains titles and file names, which may identify the patient even if the identity is hidden.
    return pdf ? io::encodeEncapsulatedPdf(pdf.value(), exportInput.session.title, io::BurnedInIdentity::Possible,
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
    return io::encodeSpatialRegistration(registration, exportInput.angiogram, exportInput.origin);
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
    auto made = vessels.lumen
                    ? io::encodeVesselSegmentation(*vessels.lumen,
                                                   vessels.isLumenEdited ? "Lumen traced in the scan and edited by hand"
                                                                         : "Lumen that the vessel tree was traced from",
                                                   exportInput.scan, exportInput.origin)
                    : io::encodeVesselSegmentation(rasterizeTree(*vessels.tree, vessels.scan->geometry),
                                                   "Centrelines drawn as tubes of their radii", exportInput.scan,
                                                   exportInput.origin);
    if (made && !exportInput.scan.source.isDicom) {
        notes.push_back(messages::dicomNoScanStudy());
    }
    return made;
}

using Line = std::vector<Eigen::Vector2d>;

io::RgbColor rgb(const ui::Color& color)
{
    return {color.red, color.green, color.blue};
}

bool passesImage(const Line& line, const core::ProjectionCamera& camera)
{
    return std::ranges::any_of(line, [&camera](const Eigen::Vector2d& point) {
        return point.x() > -0.5 && point.y() > -0.5 && point.x() < camera.width - 0.5 &&
               point.y() < camera.height - 0.5;
    });
}

/// Returns the visible vessels, with the auxiliary branches in a separate layer.
std::vector<io::GraphicLayer> vesselLayers(const DicomExportInput& exportInput, const core::ProjectionCamera& camera)
{
    const core::Case& session = exportInput.session;
    const ui::BranchColors colors = ui::branchColors(ui::palette(ui::ThemeMode::Dark));
    io::GraphicLayer plain{"VESSELS", "Vessels of the 3-D tree", rgb(colors.plain), {}, {}};
    io::GraphicLayer auxiliary{"AUXILIARY", "Auxiliary vessels of the 3-D tree", rgb(colors.auxiliary), {}, {}};
    const core::RigidTransform& pose = session.shown().cameraFromPatient;
    const DrawnVessels drawn =
        vesselsToDraw(session.shown(), session.vessels, pose, exportInput.dicomExport.imageOptions.shape);
    const core::VesselTree tree = core::withoutBranches(drawn.tree, session.vessels.hiddenBranchIds);
    for (const ui::ProjectedBranch& branch : ui::projectTree(tree, camera, pose)) {
        const std::vector<int>& ids = session.vessels.auxiliaryBranchIds;
        io::GraphicLayer& layer = std::ranges::find(ids, branch.id) == ids.end() ? plain : auxiliary;
        for (const auto& run : branch.runs) {
            Line line;
            std::ranges::transform(run, std::back_inserter(line), &ui::ProjectedPoint::px);
            if (passesImage(line, camera)) {
                layer.lines.push_back(std::move(line));
            }
        }
    }
    return {plain, auxiliary};
}

/// Returns the measurements of the frame, each labeled with its value.
io::GraphicLayer measuredLayer(const core::Case& session)
{
    io::GraphicLayer layer{"MEASURED", "Measurements in the image", {255, 200, 87}, {}, {}};
    const core::MeasurementContext context(session.shown(), session.vessels.tree.get());
    for (const core::ImageMeasurement& measurement : session.shown().measurements) {
        if (measurement.frame != session.shown().frame || measurement.pixels.empty()) {
            continue;
        }
        Line line = measurement.pixels;
        if (measurement.kind == core::MeasurementKind::Area) {
            line.push_back(line.front());
        }
        layer.lines.push_back(line);
        if (const auto measured = core::measureImage(measurement, context)) {
            layer.texts.push_back({core::labelOf(measured.value(), measurement.kind).text(), line.front()});
        }
    }
    return layer;
}

/// Converts a display range to the gray values of the file, and reverses it if the image was inverted when it was read.
core::DisplayRange storedRange(core::DisplayRange range, const core::Angiogram& run, const io::SourceImage& source)
{
    if (!source.isShownInverted) {
        return range;
    }
    float low = run.frames.front().pixels.front();
    float high = low;
    for (const core::ImageF& frame : run.frames) {
        const auto [least, most] = std::ranges::minmax_element(frame.pixels);
        low = std::min(low, *least);
        high = std::max(high, *most);
    }
    const double sum = static_cast<double>(low) + static_cast<double>(high);
    return {sum - range.high, sum - range.low};
}

core::DisplayRange shownRange(const DicomExportInput& exportInput, int frame, core::Messages& notes)
{
    const core::View& view = exportInput.session.shown();
    const core::Angiogram& run = *core::storedRunOf(view);
    const bool isTreated = view.storedRun != nullptr;
    if (isTreated) {
        notes.push_back(messages::dicomTreated());
    }
    const auto& imageOptions = exportInput.dicomExport.imageOptions;
    const core::DisplayRange range = imageOptions.range && !isTreated
                                         ? *imageOptions.range
                                         : core::displayRange(run.frames[static_cast<std::size_t>(frame)]);
    return storedRange(range, run, exportInput.angiogram);
}

/// Splits names and titles into words; names are separated by `^`, titles by blanks.
std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    for (const char letter : text + " ") {
        if (letter == '^' || letter == ' ' || letter == '=' || letter == ',') {
            if (word.size() > 2) {
                words.push_back(word);
            }
            word.clear();
        } else {
            word += letter;
        }
    }
    return words;
}

bool namesPatient(const std::string& title, const io::SourceImage& source)
{
    const std::vector<std::string> words =
        wordsOf(source.patientText(0x00100010) + " " + source.patientText(0x00100020));
    return std::ranges::any_of(words, [&](const std::string& word) { return title.find(word) != std::string::npos; });
}

/// Whether burned-in identity is possible. Text in the image is detected but not recognized, so any text may be a name.
io::BurnedInIdentity identityIn(const DicomExportInput& exportInput)
{
    const core::View& view = exportInput.session.shown();
    const core::Mask2d letters = core::burnedInTextMask(view.angiogram->frames[static_cast<std::size_t>(view.frame)],
                                                        core::thoroughMaxLetterHeight);
    const bool hasLetters = std::ranges::any_of(letters.pixels, [](std::uint8_t pixel) { return pixel != 0; });
    const bool mayBeThere = exportInput.dicomExport.imageOptions.identity == Identity::Shown ||
                            exportInput.angiogram.declaresBurnedInText || hasLetters ||
                            namesPatient(exportInput.session.title, exportInput.angiogram);
    return mayBeThere ? io::BurnedInIdentity::Possible : io::BurnedInIdentity::None;
}

/// Uses one size and one display range for all frames, and no residuals or DRR, which belong to a single frame.
OverlayImageOptions cineOverlayOptions(const DicomExportInput& exportInput)
{
    OverlayImageOptions imageOptions = exportInput.dicomExport.imageOptions;
    const core::View& view = exportInput.session.shown();
    imageOptions.isInitialPoseShown = false;
    imageOptions.coloring = OverlayColoring::Branches;
    imageOptions.drr = nullptr;
    imageOptions.widthPx = imageOptions.widthPx > 0 ? imageOptions.widthPx : view.angiogram->width();
    if (!imageOptions.range) {
        imageOptions.range = core::displayRange(view.angiogram->frames[static_cast<std::size_t>(view.frame)]);
    }
    return imageOptions;
}

/// Creates a presentation state with the overlay as vector graphics on the stored image: vessels, measurements of the
/// frame, and the notice.
core::Result<std::string> makePresentationState(const DicomExportInput& exportInput, core::Messages& notes)
{
    const core::View& view = exportInput.session.shown();
    const auto camera = core::cameraOf(view);
    if (!camera) {
        return camera.error();
    }
    io::PresentationContent shown;
    shown.layers = vesselLayers(exportInput, camera.value());
    shown.layers.push_back(measuredLayer(exportInput.session));
    shown.layers.push_back({"NOTICE", "What the overlay is", {200, 200, 200}, {}, {}});
    shown.layers.back().texts.push_back({"AngioPose. " + messages::notForClinicalUse().text(), {8.0, 16.0}});
    shown.frame = std::min(view.frame, core::storedRunOf(view)->frameCount() - 1);
    shown.description = "Vessels of a registered 3-D tree as vectors";
    if (exportInput.angiogram.isDicom) {
        shown.range = shownRange(exportInput, shown.frame, notes);
    }
    return io::encodePresentationState(shown, exportInput.angiogram, exportInput.origin);
}

/// Creates a secondary capture of the overlay on the shown frame.
core::Result<std::string> makeSecondaryCapture(const DicomExportInput& exportInput)
{
    auto picture = drawOverlay(exportInput.session, exportInput.target, exportInput.dicomExport.imageOptions);
    if (!picture) {
        return picture.error();
    }
    return io::encodeSecondaryCapture(
        {{std::move(picture).value()}, 0.0, identityIn(exportInput), messages::dicomDerivation().text()},
        exportInput.angiogram, exportInput.origin);
}

/// Creates a multi-frame secondary capture of the overlay on all frames of the cine run, each at its tracked pose, with
/// a constant display range.
core::Result<std::string> makeCineCapture(const DicomExportInput& exportInput)
{
    const core::Angiogram& run = *exportInput.session.shown().angiogram;
    MoviePlan plan;
    plan.frames = {0, run.frameCount() - 1};
    plan.followed = core::framesOf(exportInput.session.shown().followed);
    OverlayImageOptions imageOptions = cineOverlayOptions(exportInput);
    const MovieSteps steps(exportInput.session, plan, imageOptions.shape);
    io::CapturedImages capture{{}, run.frameTimeMs, identityIn(exportInput), messages::dicomDerivation().text()};
    for (std::size_t i = 0; i < steps.count(); ++i) {
        if (exportInput.shouldContinue(static_cast<double>(i) / static_cast<double>(steps.count())) ==
            core::ObserverDecision::Stop) {
            return core::Error(core::Cancellation{messages::dicomStopped()});
        }
        const MovieStep step = steps.at(i);
        imageOptions.words = step.words;
        auto picture = drawOverlay(step.session, {}, imageOptions);
        if (!picture) {
            return picture.error();
        }
        capture.images.push_back(std::move(picture).value());
    }
    return io::encodeMultiframeCapture(std::move(capture), exportInput.angiogram, exportInput.origin);
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
    return io::encodeMeasurementReport({io::reportGroups(exportInput.session), scanFrame(exportInput)},
                                       exportInput.angiogram, exportInput.origin);
}

}   // namespace angiopose::app
