#include "app/texts/movie_steps.h"

#include "app/messages/messages.h"
#include "app/texts/deformed_vessels.h"
#include "core/case/case.h"
#include "core/geometry/angle_units.h"
#include "core/registration/pose/centroid_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace angiopose::app {
namespace {

constexpr int sidePx = 512;
constexpr double filledPart = 0.86;   // fraction of the frame that the bounding sphere of the vessels fills
constexpr double distanceInRadii = 6.0;   // viewing distance in radii of that sphere; perspective as in an angiogram

/// Returns the orientation of a camera in front of the patient: left on the right, head up, depth to posterior (LPS).
Eigen::Matrix3d fromFront()
{
    return (Eigen::Matrix3d() << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0).finished();
}

/// Returns the center of the bounding box of the vessels.
Eigen::Vector3d middleOf(const core::VesselTree& tree)
{
    Eigen::AlignedBox3d box;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    return box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : box.center();
}

double radiusMm(const core::VesselTree& tree, const Eigen::Vector3d& center)
{
    double radius = 1.0;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            radius = std::max(radius, (point - center).norm());
        }
    }
    return radius;
}

core::ProjectionCamera cameraAround(double radius)
{
    const double distance = distanceInRadii * radius;
    const double pxPerSlope = 0.5 * filledPart * sidePx * (distance - radius) / radius;
    const double middle = 0.5 * (sidePx - 1);
    return {pxPerSlope, pxPerSlope, middle, middle, sidePx, sidePx};
}

/// Returns the vessels alone, rotated about the patient's long axis through their center.
core::Case rotatedBy(core::Case alone, double degrees)
{
    const core::VesselTree& tree = *alone.vessels.tree;
    const Eigen::Vector3d center = middleOf(tree);
    const Eigen::AngleAxisd turn(degrees / core::degreesPerRadian, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d rotation = fromFront() * turn.toRotationMatrix();
    const Eigen::Vector3d inFront(0.0, 0.0, distanceInRadii * radiusMm(tree, center));
    alone.shown().cameraFromPatient = core::cameraFromPatient(core::CentroidPose{rotation, inFront}, center);
    return alone;
}

/// Returns a case with the vessels alone on a dark background, in an anterior view of the patient. A new view replaces
/// the shown one and contains neither its image nor its pose. `shape` applies if a deformation is known.
core::Case vesselsAlone(const core::Case& session, VesselShape shape)
{
    core::Case alone = session;
    const core::View& shown = session.shown();
    const core::VesselTree tree = vesselsToDraw(shown, session.vessels, shown.cameraFromPatient, shape).tree;
    core::Angiogram ground;
    ground.frames = {core::ImageF(sidePx, sidePx, 0.0F)};
    if (shown.angiogram) {
        ground.identity = shown.angiogram->identity;
    }
    core::View view;
    view.imageFile = shown.imageFile;
    view.angiogram = std::make_shared<const core::Angiogram>(std::move(ground));
    view.geometry.cameraOverride = cameraAround(radiusMm(tree, middleOf(tree)));
    alone.vessels.tree = std::make_shared<const core::VesselTree>(tree);
    alone.shown() = view;
    return rotatedBy(std::move(alone), 0.0);
}

constexpr double defaultFrameRate = 15.0;   // used if the file states no frame rate
constexpr double turnSeconds = 6.0;
constexpr double finalPoseMs = 1500.0;   // display time of the final pose of a convergence
constexpr double msPerSecond = 1000.0;

bool isDistrusted(const core::View& view)
{
    return view.result && !view.result->trustworthy;
}

/// Sets another pose and removes all results and measurements that refer to the previous one.
void setPose(core::Case& session, const core::RigidTransform& pose)
{
    core::View& view = session.shown();
    if (pose.matrix() == view.cameraFromPatient.matrix()) {
        return;
    }
    view.cameraFromPatient = pose;
    view.result.reset();
    view.measurements.clear();
    view.observations.clear();
}

std::size_t turnSteps(const MoviePlan& plan)
{
    return static_cast<std::size_t>(std::max(2L, std::lround(turnSeconds * plan.framesPerSecond)));
}

std::size_t stepCount(const core::Case& session, const MoviePlan& plan)
{
    const auto frames = static_cast<std::size_t>(std::max(1, plan.frames.count()));
    switch (plan.content) {
        case MovieContent::Convergence:
            return session.shown().result ? session.shown().result->history.size() : 0;
        case MovieContent::Turn:
            return turnSteps(plan);
        case MovieContent::Run:
            break;
    }
    return plan.order == core::CineOrder::BackAndForth && frames > 1 ? 2 * (frames - 1) : frames;
}

}   // namespace

double framesPerSecondOf(const core::Angiogram& run)
{
    return run.frameTimeMs > 1.0 ? msPerSecond / run.frameTimeMs : defaultFrameRate;
}

std::optional<core::Message> findProblem(const core::Case& session, const MoviePlan& plan)
{
    if (!session.vessels.tree || !session.shown().angiogram || session.shown().angiogram->frames.empty()) {
        return messages::overlayIncomplete();
    }
    const auto& result = session.shown().result;
    if (plan.content == MovieContent::Convergence && (!result || result->history.empty())) {
        return messages::movieNoHistory();
    }
    const int last = session.shown().angiogram->frameCount() - 1;
    if (plan.content == MovieContent::Run &&
        (plan.frames.first < 0 || plan.frames.last > last || plan.frames.first > plan.frames.last)) {
        return messages::movieFramesBeyond(plan.frames.first + 1, plan.frames.last + 1, last + 1);
    }
    return std::nullopt;
}

MovieLength movieLength(const core::Case& session, const MoviePlan& plan)
{
    const std::size_t pictures = stepCount(session, plan);
    const double restSeconds = plan.content == MovieContent::Convergence && pictures > 0
                                   ? finalPoseMs / msPerSecond - 1.0 / plan.framesPerSecond
                                   : 0.0;
    return {pictures, static_cast<double>(pictures) / plan.framesPerSecond + std::max(0.0, restSeconds)};
}

double movieAspect(const core::Case& session, const MoviePlan& plan)
{
    const auto& run = session.shown().angiogram;
    return plan.content == MovieContent::Turn || !run || run->width() == 0
               ? 1.0
               : static_cast<double>(run->height()) / run->width();
}

MovieSteps::MovieSteps(const core::Case& session, const MoviePlan& plan, VesselShape shape)
    : case_(session), plan_(plan)
{
    if (plan.content == MovieContent::Turn) {
        const core::View& shown = session.shown();
        const DrawnVessels drawn = vesselsToDraw(shown, session.vessels, shown.cameraFromPatient, shape);
        if (drawn.known) {
            rotationNote_ = shapeLines(drawn).front();
        }
        case_ = vesselsAlone(session, shape);
    }
}

std::size_t MovieSteps::count() const
{
    return stepCount(case_, plan_);
}

MovieStep MovieSteps::at(std::size_t index) const
{
    if (plan_.content == MovieContent::Run) {
        return frameStep(index);
    }
    if (plan_.content == MovieContent::Convergence) {
        return iterationStep(index);
    }
    const double degrees = 360.0 * static_cast<double>(index) / static_cast<double>(count());
    const core::Message turn = messages::movieTurned(core::Quantity{degrees, 0, "°"});
    return {rotatedBy(case_, degrees), rotationNote_ ? messages::twoParts(turn, *rotationNote_) : turn,
            msPerSecond / plan_.framesPerSecond};
}

MovieStep MovieSteps::frameStep(std::size_t index) const
{
    const core::CineClock clock(plan_.frames, plan_.order, 1.0);
    const int frame = clock.frameAt(static_cast<double>(index));
    const core::View& own = case_.shown();
    MovieStep step{case_, std::nullopt, msPerSecond / plan_.framesPerSecond};
    step.session.shown().frame = frame;
    if (frame == own.frame) {
        return step;
    }
    const auto followed = std::ranges::find(plan_.followed, frame, &core::TrackedRunFrame::frame);
    if (followed == plan_.followed.end()) {
        step.words = messages::moviePoseOfFrame(own.frame + 1);
        return step;
    }
    setPose(step.session, followed->tracked.cameraFromPatient);
    step.words = followed->tracked.isTrustworthy && !isDistrusted(own) ? messages::movieFollowed()
                                                                       : messages::movieFollowedDistrusted();
    return step;
}

MovieStep MovieSteps::iterationStep(std::size_t index) const
{
    const core::View& own = case_.shown();
    const std::vector<core::IterationReport>& history = own.result->history;
    const core::IterationReport& report = history[index];
    const core::Quantity median{report.medianDistancePx, 2, "px"};
    const bool isLast = index + 1 == history.size();
    const double durationMs = msPerSecond / plan_.framesPerSecond;
    MovieStep step{case_, std::nullopt, isLast ? std::max(finalPoseMs, durationMs) : durationMs};
    setPose(step.session, report.cameraFromPatient);
    step.words = isDistrusted(own) ? messages::movieStepDistrusted(index + 1, history.size(), median)
                                   : messages::movieStep(index + 1, history.size(), median);
    return step;
}

}   // namespace angiopose::app
