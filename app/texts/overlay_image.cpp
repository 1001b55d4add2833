#include "app/texts/overlay_image.h"

#include "app/messages/messages.h"
#include "app/texts/fit_basis_lines.h"
#include "app/texts/image_marks.h"
#include "app/texts/number_text.h"
#include "core/case/case_patients.h"
#include "core/case/initial_pose.h"
#include "core/evaluation/trial/branch_distances.h"
#include "core/imaging/display_range.h"
#include "ui/scenes/burn_marks.h"
#include "ui/scenes/burn_text.h"
#include "ui/scenes/overlay_scene.h"
#include "ui/scenes/render_offscreen.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

namespace angiopose::app {
namespace {

constexpr double residualScaleMaximumMm = 2.0;

void setAutomaticWindow(ui::OverlayScene& scene, const core::ImageF& frame)
{
    const core::DisplayRange range = core::displayRange(frame);
    scene.setWindowLevel(range.window(), range.level());
}

ui::ViewRect wholeImage(const core::ImageF& frame)
{
    return {-0.5, frame.width - 0.5, -0.5, frame.height - 0.5};
}

/// Returns the corner text of an exported image; `heading` distinguishes two images side by side.
ui::CornerTexts exportTexts(const core::Case& session, const core::Centerline2d& target,
                            const OverlayImageOptions& options, const DrawnVessels& drawn,
                            const std::optional<core::Message>& heading)
{
    CornerLines lines = cornerLines(session, options.identity);
    lines.topRight.insert(lines.topRight.begin(), messages::notForClinicalUse());
    if (heading) {
        lines.bottomLeft.push_back(*heading);
    }
    if (const int count = session.shown().angiogram->frameCount(); count > 1) {
        lines.bottomLeft.push_back(messages::frameOfRun(session.shown().frame + 1, count));
    }
    if (const core::RegistrationResult* const result = core::resultOfShownFrame(session.shown())) {
        const core::Quantity median{result->metrics.medianPx, 2, "px"};
        const core::Message pose = result->trustworthy ? messages::poseOfMethod(result->method, median)
                                                       : messages::poseNotTrustworthy(result->method, median);
        lines.bottomLeft.push_back(drawn.shape == VesselShape::Deformed ? messages::ofRigidVessels(pose) : pose);
        if (const auto basis = core::fitBasis(session, *result, target)) {
            const core::Messages words = fitBasisLines(*basis, session.vessels);
            lines.bottomLeft.insert(lines.bottomLeft.end(), words.begin(), words.end());
        }
    } else if (const auto& elsewhere = session.shown().result) {   // the result belongs to another frame
        const core::Message pose = messages::moviePoseOfFrame(elsewhere->provenance.frame.value_or(0) + 1);
        if (heading != pose) {
            lines.bottomLeft.push_back(pose);
        }
        if (!elsewhere->trustworthy) {
            lines.bottomLeft.push_back(messages::runDistrusted());
        }
    } else if (!heading && core::isAtInitialPose(session.shown(), session.vessels)) {
        lines.bottomLeft.push_back(messages::poseAtStart());
    }
    if (drawn.known) {
        const core::Messages shape = shapeLines(drawn);
        lines.bottomLeft.insert(lines.bottomLeft.end(), shape.begin(), shape.end());
        lines.scaleHeading =
            options.coloring == OverlayColoring::Motion ? std::optional(motionHeading()) : std::nullopt;
    }
    ui::CornerTexts texts = options.texts(lines);
    texts.topLeft.insert(texts.topLeft.begin(), session.title);   // untranslated, since the user typed it
    return texts;
}

DrawnVessels shownVessels(const core::Case& session, VesselShape preferredShape)
{
    return vesselsToDraw(session.shown(), session.vessels, session.shown().cameraFromPatient, preferredShape);
}

void dressScene(ui::OverlayScene& scene, const core::Case& session, const core::ProjectionCamera& camera,
                const core::VesselTree& tree)
{
    const core::ImageF& frame = session.shown().angiogram->frames[static_cast<std::size_t>(session.shown().frame)];
    scene.setFrame(frame);
    setAutomaticWindow(scene, frame);
    scene.setCamera(camera);
    scene.setTree(core::withoutBranches(tree, session.vessels.hiddenBranchIds));
    scene.setPose(session.shown().cameraFromPatient);
    ui::BranchMarks marks;
    marks.auxiliary = {session.vessels.auxiliaryBranchIds.begin(), session.vessels.auxiliaryBranchIds.end()};
    marks.excluded = {session.vessels.excludedBranchIds.begin(), session.vessels.excludedBranchIds.end()};
    scene.setMarks(marks);
}

std::string poseText(const core::RigidTransform& pose)
{
    std::string text;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += (text.empty() ? "" : " ") + fixedText(pose.matrix()(row, column), 9);
        }
    }
    return text;
}

}   // namespace

double residualScaleMaximumPx(const core::ProjectionCamera& camera, double depthMm)
{
    return residualScaleMaximumMm / core::millimetersPerPixel(camera, depthMm);
}

namespace {

/// Maximum of the color scale; 0 if there is no scale.
struct ColorScaleMaximum {
    double px = 0.0;
    double mm = 0.0;
};

ColorScaleMaximum colorVessels(ui::OverlayScene& scene, const core::Case& session, const core::Centerline2d& target,
                               const OverlayImageOptions& options, const DrawnVessels& drawn)
{
    const core::ProjectionCamera camera = core::cameraOf(session.shown()).value();
    const core::RigidTransform& pose = session.shown().cameraFromPatient;
    const double depthMm = (pose * core::centroidInPatient(*session.vessels.tree)).z();
    const double shownDepthMm = std::max(depthMm, core::minProjectableDepthMm);
    if (options.coloring == OverlayColoring::Motion && drawn.known) {
        const double endMm = drawn.motion.scaleMaximumMm;
        scene.setResiduals(drawn.motion.distanceMm, endMm);
        return {endMm / core::millimetersPerPixel(camera, shownDepthMm), endMm};
    }
    if (options.coloring == OverlayColoring::Branches || target.pointCount() == 0) {
        return {};
    }
    const double endPx = residualScaleMaximumPx(camera, shownDepthMm);
    scene.setResiduals(core::branchDistances(drawn.tree, target, camera, pose), endPx);
    return {endPx, residualScaleMaximumMm};
}

/// Applies the options to the scene; returns the maximum of the color scale.
ColorScaleMaximum styleScene(ui::OverlayScene& scene, const core::Case& session, const core::Centerline2d& target,
                             const OverlayImageOptions& options, const DrawnVessels& drawn)
{
    scene.setMode(options.drr ? ui::OverlayMode::Hidden : options.vessels);
    scene.setDepthCue(options.depthCue);
    scene.setCutout(options.cutout);
    if (options.range) {
        scene.setWindowLevel(options.range->window(), options.range->level());
    }
    return scene.mode() == ui::OverlayMode::Hidden ? ColorScaleMaximum{}
                                                   : colorVessels(scene, session, target, options, drawn);
}

/// Returns the measurements of the frame and the vessel marks, labeled in the language of the image.
std::vector<ui::ImageMark> marksIn(const core::Case& session, const OverlayImageOptions& options)
{
    const auto toText = [&options](const core::Message& message) {
        return options.texts({.topLeft = {message}, .topRight = {}, .bottomLeft = {}, .bottomRight = {}})
            .topLeft.front();
    };
    std::vector<ui::ImageMark> marks =
        marksOf({session.shown(), session.vessels.tree.get()}, session.shown().frame, toText);
    const MarkedView placed{session, session.shownView, session.shown().frame,
                            options.drr ? VesselShape::Rigid : options.shape};
    const std::vector<ui::ImageMark> places = placedMarks(placed, toText);
    marks.insert(marks.end(), places.begin(), places.end());
    return marks;
}

/// Returns the points of the projected vessels, which labels avoid.
std::vector<Eigen::Vector2d> drawnPoints(const ui::OverlayScene& scene)
{
    std::vector<Eigen::Vector2d> points;
    for (const ui::ProjectedBranch& branch : scene.content().projected) {
        for (const auto& run : branch.runs) {
            std::ranges::transform(run, std::back_inserter(points), &ui::ProjectedPoint::px);
        }
    }
    return points;
}

/// Renders to pixels or to vector graphics, depending on `Picture`.
template <class Picture>
core::Result<Picture> drawScene(ui::OverlayScene& scene, const auto&... how)
{
    if constexpr (std::is_same_v<Picture, ui::VectorImage>) {
        return ui::drawVectors(scene, how...);
    } else {
        return ui::renderOffscreen(scene, how...);
    }
}

template <class Picture>
core::Result<Picture> drawOne(const core::Case& session, const core::Centerline2d& target,
                              const OverlayImageOptions& options, const std::optional<core::Message>& heading)
{
    const auto camera = core::cameraOf(session.shown());
    if (!camera) {
        return camera.error();
    }
    ui::OverlayScene scene;
    const DrawnVessels drawn = shownVessels(session, options.drr ? VesselShape::Rigid : options.shape);
    dressScene(scene, session, camera.value(), drawn.tree);
    const ColorScaleMaximum scale = styleScene(scene, session, target, options, drawn);
    const core::ImageF& frame = session.shown().angiogram->frames.front();
    const int width = options.widthPx > 0 ? options.widthPx : 2 * frame.width;
    const int height =
        std::max(1, static_cast<int>(std::lround(static_cast<double>(width) * frame.height / frame.width)));
    scene.setLineWidthPx(std::max(1.5, width / 512.0 * 1.5));
    if (options.drr) {
        const auto drr = options.drr(session.shown().cameraFromPatient);
        if (!drr) {
            return drr.error();
        }
        scene.setDrr(drr.value());
    }
    auto rendered = drawScene<Picture>(scene, width, height, wholeImage(frame),
                                       exportTexts(session, target, options, drawn, heading), scale.px, scale.mm);
    if (!rendered) {
        return rendered.error();
    }
    Picture picture = std::move(rendered).value();
    if (const auto& result = session.shown().result; result && !result->trustworthy) {
        const std::string words =
            options.texts({.topLeft = {messages::notReliable()}, .topRight = {}, .bottomLeft = {}, .bottomRight = {}})
                .topLeft.front();
        ui::burnVerdict(picture, words, ui::burnSizes(width, height));
    }
    ui::burnMarks(picture, marksIn(session, options), wholeImage(frame), ui::burnSizes(width, height),
                  drawnPoints(scene));
    return picture;
}

int gapBeside(int width)
{
    return std::max(2, width / 256);
}

ui::VectorImage joinImages(const ui::VectorImage& left, const ui::VectorImage& right)
{
    return ui::joinSideBySide(left, right, gapBeside(left.width));
}

/// Joins two images of the same size with a dark line between them.
core::ColorImage joinImages(const core::ColorImage& left, const core::ColorImage& right)
{
    const int gap = gapBeside(left.width);
    core::ColorImage both{2 * left.width + gap, left.height, {}};
    const auto row = [](const core::ColorImage& picture) { return 3 * static_cast<std::size_t>(picture.width); };
    both.rgb.resize(row(both) * static_cast<std::size_t>(both.height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(both.height); ++y) {
        std::uint8_t* to = both.rgb.data() + y * row(both);
        std::copy_n(left.rgb.data() + y * row(left), row(left), to);
        std::copy_n(right.rgb.data() + y * row(right), row(right), to + row(both) - row(right));
    }
    return both;
}

template <class Picture>
core::Result<Picture> drawAs(const core::Case& session, const core::Centerline2d& target,
                             const OverlayImageOptions& options)
{
    if (!session.vessels.tree || !session.shown().angiogram || session.shown().angiogram->frames.empty()) {
        return core::Error(messages::overlayIncomplete());
    }
    if (!options.isInitialPoseShown) {
        return drawOne<Picture>(session, target, options, options.words);
    }
    const auto start = core::initialPoseOf(session);
    if (!start) {
        return start.error();
    }
    core::Case before = session;
    before.shown().cameraFromPatient = start.value();
    before.shown().result.reset();
    before.shown().measurements.clear();   // measured values would differ at this pose
    before.shown().observations.clear();
    const auto left = drawOne<Picture>(before, target, options, messages::beforeAtStart());
    const auto right = drawOne<Picture>(session, target, options, messages::afterAtPose());
    if (!left) {
        return left.error();
    }
    if (!right) {
        return right.error();
    }
    return joinImages(left.value(), right.value());
}

}   // namespace

core::Result<core::ColorImage> drawOverlay(const core::Case& session, const core::Centerline2d& target,
                                           const OverlayImageOptions& options)
{
    return drawAs<core::ColorImage>(session, target, options);
}

core::Result<ui::VectorImage> drawOverlayVectors(const core::Case& session, const core::Centerline2d& target,
                                                 const OverlayImageOptions& options)
{
    return drawAs<ui::VectorImage>(session, target, options);
}

core::Result<core::ColorImage> drawThumbnail(const core::Case& session, int widthPx, const core::Centerline2d* target)
{
    const auto& angiogram = session.shown().angiogram;
    if (!session.vessels.tree || !angiogram || session.shown().frame >= angiogram->frameCount()) {
        return core::Error(messages::pictureIncomplete());
    }
    const auto camera = core::cameraOf(session.shown());
    if (!camera) {
        return camera.error();
    }
    ui::OverlayScene scene;
    const DrawnVessels drawn = shownVessels(session, VesselShape::Deformed);
    dressScene(scene, session, camera.value(), drawn.tree);
    if (target) {
        colorVessels(scene, session, *target, {}, drawn);
    }
    const core::ImageF& frame = angiogram->frames[static_cast<std::size_t>(session.shown().frame)];
    const int height = std::max(1, widthPx * frame.height / frame.width);
    scene.setLineWidthPx(
        std::max(1.0, widthPx / (target ? 200.0 : 80.0)));   // thinner lines suffice if colors show the residuals
    return ui::renderOffscreen(scene, widthPx, height, wholeImage(frame));
}

std::map<std::string, std::string> provenanceTexts(const core::Case& session)
{
    std::map<std::string, std::string> texts{
        {"Software", std::string("AngioPose ") + ANGIOPOSE_VERSION},
        {"Disclaimer", messages::notForClinicalUse().text()},
        {"Centreline", session.vessels.file.sha256},
        {"Angiogram", session.shown().imageFile.sha256 + " frame " + std::to_string(session.shown().frame + 1)},
        {"cameraFromPatient", poseText(session.shown().cameraFromPatient)},
    };
    if (const auto& result = session.shown().result) {
        texts["Method"] = result->method;
        if (core::resultOfShownFrame(session.shown())) {
            texts["Trustworthy"] = result->trustworthy ? "yes" : "no";
        }
        for (const core::Message& warning : result->warnings) {
            texts["Warnings"] += warning.text() + "\n";
        }
        texts["Found in"] = "frame " + std::to_string(result->provenance.frame.value_or(session.shown().frame) + 1);
        texts["Found"] = result->provenance.time;
        texts["Found by"] = result->provenance.author;
    }
    for (const core::Message& mismatch : core::findMismatch(session)) {
        texts["Patient"] += mismatch.text() + "\n";
    }
    std::erase_if(texts, [](const auto& entry) { return entry.second.empty(); });
    return texts;
}

}   // namespace angiopose::app
