#include "app/cli/register_outputs.h"

#include "app/messages/messages.h"
#include "app/texts/fit_basis_lines.h"
#include "app/texts/number_text.h"
#include "app/texts/overlay_image.h"
#include "core/case/case_views.h"
#include "core/geometry/angle_units.h"
#include "core/registration/deformable/deformed_tree.h"
#include "core/registration/judging/mismatched_branches.h"
#include "core/registration/judging/pose_uncertainty.h"
#include "io/case/input_case.h"
#include "io/image_file.h"
#include "io/motion_table.h"
#include "io/pose_file.h"
#include "io/results/result_file.h"
#include "io/support/atomic_file.h"
#include "io/vessel_tree_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using core::RegisteredCase;

core::Case caseShowing(const RegisteredCase& registered, std::size_t index)
{
    return core::withShownView(registered.session, registered.viewIndices[index]);
}

std::string viewFolder(const RegisteredCase& registered, const std::string& folder, std::size_t index)
{
    const std::string number = std::to_string(registered.viewIndices[index] + 1);
    return index == 0 ? folder : (fs::path(folder) / ("view-" + number)).string();
}

/// View to write, with its result as JSON, both for a file and for image metadata.
struct WrittenView {
    core::Case session;   ///< case that displays this view
    const core::Centerline2d* target = nullptr;
    std::string result;   ///< result as JSON
    std::string resultInImages;   ///< result as JSON without names, for image metadata, since images may be shared
};

WrittenView writtenView(const RegisteredCase& registered, std::size_t k, OverlayImages pictures)
{
    const std::size_t place = registered.viewIndices[k];
    return {
        caseShowing(registered, k), &registered.targets[k], io::resultJson(registered, place, io::ResultTexts::Kept),
        pictures == OverlayImages::Drawn ? io::resultJson(registered, place, io::ResultTexts::LeftOut) : std::string()};
}

core::Status writePicture(const WrittenView& view, const OverlayImageOptions& options, const fs::path& path)
{
    const auto picture = drawOverlay(view.session, *view.target, options);
    std::map<std::string, std::string> texts = provenanceTexts(view.session);
    texts["Result"] = view.resultInImages;
    return picture ? io::writePng(picture.value(), path.string(), texts) : core::Status(picture.error());
}

/// Writes the images as shown in the window. For deformed vessels, also writes the rigid ones and the displacement map.
core::Status writePictures(const WrittenView& view, const fs::path& folder)
{
    OverlayImageOptions options;
    if (auto status = writePicture(view, options, folder / "overlay.png"); !status) {
        return status;
    }
    const core::View& shown = view.session.shown();
    if (!deformationForPose(shown, view.session.vessels, shown.cameraFromPatient)) {
        return core::Done{};
    }
    options.coloring = OverlayColoring::Motion;
    if (auto status = writePicture(view, options, folder / "motion.png"); !status) {
        return status;
    }
    options.coloring = OverlayColoring::Residuals;
    options.shape = VesselShape::Rigid;
    return writePicture(view, options, folder / "rigid.png");
}

core::Status writeView(const WrittenView& view, OverlayImages pictures, const std::string& folderName)
{
    const fs::path folder(folderName);
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) {
        return core::Error(messages::folderNotMade(folder.string(), failure.message()));
    }
    if (auto status = io::writeAtomically((folder / "result.json").string(), view.result); !status) {
        return status;
    }
    if (auto status = io::writePose(view.session.shown().cameraFromPatient, (folder / "pose.tfm").string()); !status) {
        return status;
    }
    return pictures == OverlayImages::Drawn ? writePictures(view, folder) : core::Status(core::Done{});
}

/// Returns whether to write a deformation: true if there is one or the user requested one.
bool isDeformedWritten(const RegisteredCase& registered)
{
    return registered.result().deformed && (registered.result().deformed->verdict != core::DeformationVerdict::Rigid ||
                                            registered.session.options.deformation == core::Deformation::Always);
}

/// Writes the tree as deformed in the image, in patient coordinates, and the displacement of each point.
core::Status writeDeformed(const RegisteredCase& registered, const std::string& folderName)
{
    const fs::path folder(folderName);
    const core::VesselTree& tree = *registered.session.vessels.tree;
    if (auto status = io::writeVesselTree(core::deformedTree(tree, *registered.result().deformed),
                                          (folder / "bent.vtp").string());
        !status) {
        return status;
    }
    return io::writeMotion(tree, *registered.result().deformed, (folder / "motion.csv").string());
}

void printLine(const std::string& label, const std::string& text)
{
    std::printf("%-14s %s\n", label.c_str(), text.c_str());
}

/// Prints the distances of the shown view or, for a joint registration, of each view with its geometry correction.
void printViews(const RegisteredCase& registered)
{
    for (std::size_t k = 0; registered.joint && k < registered.viewIndices.size(); ++k) {
        const core::View& view = registered.session.views[registered.viewIndices[k]];
        const core::DistanceMetrics& metrics = view.result->metrics;
        const core::Vector6d& correction = registered.joint->corrections[k];
        std::printf("view %-9zu median %s px (%s mm), coverage %s %%, geometry off by %s° and %s mm  %s\n",
                    registered.viewIndices[k] + 1, fixedText(metrics.medianPx, 2).c_str(),
                    fixedText(metrics.medianMm, 2).c_str(), fixedText(100.0 * metrics.coverage, 0).c_str(),
                    fixedText(core::degreesPerRadian * correction.head<3>().norm(), 2).c_str(),
                    fixedText(correction.tail<3>().norm(), 2).c_str(),
                    fs::path(view.imageFile.path).filename().string().c_str());
    }
    if (!registered.joint) {
        const core::RegistrationResult& result = registered.result();
        const core::DistanceMetrics& metrics = result.metrics;
        printLine("distance", "median " + fixedText(metrics.medianPx, 2) + " px (" + fixedText(metrics.medianMm, 2) +
                                  " mm), 95 % " + fixedText(metrics.p95Px, 2) + " px (" + fixedText(metrics.p95Mm, 2) +
                                  " mm)");
        printLine("covered", fixedText(100.0 * metrics.coverage, 0) + " % of the traced vessels");
    }
    if (const auto basis = core::fitBasis(registered.session, registered.result(), registered.targets.front())) {
        for (const core::Message& words : fitBasisLines(*basis, registered.session.vessels)) {
            printLine("", words.text());
        }
    }
}

/// Formats the measured stages, e.g. " (reading 812 ms, tracing 70 ms)".
std::string stageTimesText(const core::StageTimes& time)
{
    std::string parts;
    for (const auto& [what, ms] : {std::pair("reading ", time.readMs), std::pair("tracing ", time.traceMs)}) {
        if (!std::isnan(ms)) {
            parts += (parts.empty() ? "" : ", ") + (what + fixedText(ms, 0)) + " ms";
        }
    }
    return parts.empty() ? "" : " (" + parts + ")";
}

void printDeformed(const core::DeformableResult& deformed)
{
    const bool isCertain = deformed.verdict == core::DeformationVerdict::Deformed;   // "bent" in files
    printLine("vessels", (isCertain ? "deformed" : std::string(core::toText(deformed.verdict))) + ", evidence " +
                             fixedText(deformed.logEvidenceGain, 0) + ", displaced by " +
                             fixedText(deformed.meanMotionMm, 1) + " mm on average, " +
                             fixedText(deformed.largestMotionMm, 1) + " mm maximum, " + fixedText(deformed.timeMs, 0) +
                             " ms");
    for (const core::Message& message : deformed.messages) {
        printLine("", message.text());
    }
}

std::string sigmasText(const core::PoseSigmas& sigmas, int depthDecimals)
{
    return "in-plane ±" + fixedText(sigmas.inPlaneMm, 2) + " mm, depth ±" + fixedText(sigmas.depthMm, depthDecimals) +
           " mm, rotation ±" + fixedText(sigmas.rotationDeg.maxCoeff(), 2) + "°";
}

/// Formats the probability if known, e.g. ", within 2 mm of the vessels with a probability of 97 %". It is capped at 99
/// %, the limit of the calibration.
std::string probabilityText(const core::RegistrationResult& result)
{
    const auto& probability = result.probabilityWithin2Mm;
    const bool contradicts =
        probability && !result.trustworthy && *probability >= 0.8;   // possible only in results of earlier versions
    return probability && !contradicts ? ", within 2 mm of the vessels with a probability of " +
                                             fixedText(std::clamp(100.0 * *probability, 1.0, 99.0), 0) + " %"
                                       : "";
}

void printTrust(const core::RegistrationResult& result)
{
    printLine("trustworthy",
              (result.trustworthy ? "yes" : "NO: " + messages::notReliable().text()) + probabilityText(result));
    for (const core::Message& warning : result.warnings) {
        printLine("", warning.text());
    }
}

/// Lists the branches of the shown view with large residuals although the pose may be correct; the window shows the
/// same list.
void printDisagreeingBranches(const RegisteredCase& registered)
{
    const core::DistanceMetrics& metrics = registered.result().metrics;
    const double mmPerPx = metrics.meanPx > 0.0 ? metrics.meanMm / metrics.meanPx : 0.0;
    const core::MismatchedBranches found = core::mismatchedBranches(registered.result(), mmPerPx);
    if (found.branchIds.empty()) {
        return;
    }
    std::string names;
    for (const int id : found.branchIds) {
        names += (names.empty() ? "" : ", ") + std::to_string(id);
    }
    printLine("", (found.branchIds.size() == 1 ? "branch " : "branches ") + names + " up to " +
                      fixedText(found.maxDistanceMm, 1) + " mm off: possibly unopacified in this frame, or displaced");
}

/// Formats a path: "branches 3, 7, 9: 82 %, 95 % of the guidewire along these branches, 1.2 mm from their centerlines".
std::string pathText(const core::WirePath& way)
{
    std::string branches;
    for (const int id : way.branchIds) {
        branches += (branches.empty() ? "" : ", ") + std::to_string(id);
    }
    return "branches " + branches + ": " + fixedText(100.0 * way.probability, 0) + " %, " +
           fixedText(100.0 * way.followedShare, 0) + " % of the guidewire along these branches, " +
           fixedText(way.offAxisMm, 1) + " mm from their centerlines";
}

void printPaths(const std::vector<core::WirePath>& paths)
{
    constexpr std::size_t maxPrinted = 3;
    for (std::size_t i = 0; i < std::min(paths.size(), maxPrinted); ++i) {
        printLine(i == 0 ? "path taken" : "or", pathText(paths[i]));
    }
    if (paths.size() > 1) {
        printLine("", "--set wireWay=2 selects the next most likely path.");
    }
}

}   // namespace

core::Status writeOutputs(const RegisteredCase& registered, const std::string& folder, OverlayImages pictures)
{
    for (std::size_t k = 0; k < registered.viewIndices.size(); ++k) {
        const WrittenView view = writtenView(registered, k, pictures);
        if (auto status = writeView(view, pictures, viewFolder(registered, folder, k)); !status) {
            return status;
        }
    }
    if (isDeformedWritten(registered)) {
        if (auto status = writeDeformed(registered, folder); !status) {
            return status;
        }
    }
    return registered.joint ? io::writeJointResult(registered, (fs::path(folder) / "joint.json").string(),
                                                   io::inputCaseJson(registered))
                            : core::Status(core::Done{});
}

std::vector<std::string> listOutputs(const std::string& folder)
{
    constexpr std::array ofView{"result.json", "pose.tfm", "overlay.png", "motion.png", "rigid.png"};
    constexpr std::array ofCase{"joint.json", "bent.vtp", "motion.csv"};
    std::vector<std::string> names(ofCase.begin(), ofCase.end());
    names.insert(names.end(), ofView.begin(), ofView.end());
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator(folder, failed)) {
        const std::string name = entry.path().filename().string();
        for (const char* each : ofView) {
            if (name.starts_with("view-")) {
                names.push_back((fs::path(name) / each).string());
            }
        }
    }
    std::erase_if(names,
                  [&](const std::string& name) { return !fs::is_regular_file(fs::path(folder) / name, failed); });
    std::ranges::sort(names);
    return names;
}

void removeOutputs(const std::string& folder)
{
    for (const std::string& name : listOutputs(folder)) {
        std::error_code failed;
        fs::remove(fs::path(folder) / name, failed);
        fs::remove((fs::path(folder) / name).parent_path(),
                   failed);   // folder of a view, which is removed only if it is empty
    }
}

void printSummary(const RegisteredCase& registered, const std::string& folder)
{
    const core::RegistrationResult& result = registered.result();
    if (!result.trustworthy) {   // a low-confidence warning comes first
        printTrust(result);
    }
    printLine("method", result.method);
    printLine("stopped", std::string(core::toText(result.stopReason)) +
                             (registered.joint ? "" : " after " + std::to_string(result.iterations) + " iterations") +
                             ", " + fixedText(result.time.totalMs, 1) + " ms" + stageTimesText(result.time));
    printViews(registered);
    const core::PoseUncertainty& uncertainty = result.uncertainty;
    const int depthDecimals = registered.joint ? 2 : 1;
    const std::string inSpace = sigmasText(core::sigmasOf(uncertainty.covariance), depthDecimals);
    if (result.camera) {
        printLine("uncertainty",
                  sigmasText(core::sigmasOf(uncertainty.imageCovariance), depthDecimals) + " from image noise only");
        printLine("", inSpace + " in 3-D, including geometry uncertainty");
    } else {
        printLine("uncertainty", inSpace);
    }
    if (result.trustworthy) {
        printTrust(result);
    }
    printDisagreeingBranches(registered);
    printPaths(result.wirePaths);
    if (registered.result().deformed) {
        printDeformed(*registered.result().deformed);
    }
    const std::string deformedFiles = isDeformedWritten(registered) ? ", bent.vtp, motion.csv" : "";
    printLine("written", registered.joint
                             ? (fs::path(folder) / "joint.json").string() + deformedFiles
                             : (fs::path(folder) / "overlay.png").string() + ", result.json, pose.tfm" + deformedFiles);
}

}   // namespace angiopose::app
