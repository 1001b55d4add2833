// Compares methods for deformed vessels in the frames of a run: distance from the truth in the image plane (mm at the
// object, mean over all points and frames) when the vessels are tracked rigidly, when every frame is deformed from
// scratch, when each frame starts from the previous deformation, and when the deformations are smoothed in time; the
// computing time; and the accuracy of the estimated breathing period.

#include "core/registration/deformable/deformed_tree.h"
#include "core/registration/deformable/smooth_deformations.h"
#include "core/registration/registration.h"
#include "core/registration/run_periods.h"
#include "core/registration/vessel_tracker.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/support/stopwatch.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/deformed_cases.h"
#include "tests/benchmark/graph_trees.h"

#include <cstdio>

using namespace angiopose;
using benchmarks::DeformedCase;
using benchmarks::DeformedFrame;
using benchmarks::TrueMotion;

namespace {

using core::fixedText;
using Form = TrueMotion::Form;

const char* const usage =
    "deformed_run_table\n"
    "  --cases <n>       per row (5)\n"
    "  --frames <n>      of each run, 15 in a second (60)\n"
    "  --trees <which>   real: cerebral trees, to judge; grown: simulated ones, to choose options (real)\n"
    "  --each            a line for every run too\n";

constexpr double framesPerSecond = 15.0;
constexpr double framesPerBreath = 30.0;
constexpr double breathMm = 8.0;

const std::vector<TrueMotion> motions{{Form::None, 0, 0},   {Form::Field, 40, 2}, {Form::Field, 40, 3},
                                      {Form::Field, 80, 3}, {Form::Waves, 40, 3}, {Form::Half, 0, 6},
                                      {Form::Wire, 0, 4}};

struct Outcome {
    double rigidMm = 0.0;
    double coldMm = 0.0;
    double followedMm = 0.0;
    double smoothMm = 0.0;
    double coverage = 0.0;   ///< coverage of the 95 % ellipses, smoothed
    double unrestMm = 0.0;   ///< rms change of the error from frame to frame, not smoothed
    double smoothUnrestMm = 0.0;
    double lost = 0.0;   ///< share of the frames
    std::vector<double> coldMs;
    std::vector<double> followedMs;   ///< pose and deformation
    double periodOffS = -1.0;   ///< −1: none found
};

struct Found {
    core::VesselTree tree;
    core::RigidTransform pose;
};

std::vector<Eigen::Vector2d> errorsOf(const DeformedFrame& frame, const Found& found)
{
    std::vector<Eigen::Vector2d> errors;
    for (std::size_t b = 0; b < found.tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < found.tree.branches[b].pointsInPatient.size(); ++i) {
            const Eigen::Vector3d there = found.pose * found.tree.branches[b].pointsInPatient[i];
            const Eigen::Vector3d truth = frame.view.truth * frame.deformed.branches[b].pointsInPatient[i];
            errors.emplace_back(truth.z() * (there.head<2>() / there.z() - truth.head<2>() / truth.z()));
        }
    }
    return errors;
}

double meanError(const DeformedFrame& frame, const Found& found)
{
    const std::vector<Eigen::Vector2d> errors = errorsOf(frame, found);
    double sum = 0.0;
    for (const Eigen::Vector2d& error : errors) {
        sum += error.norm();
    }
    return sum / static_cast<double>(errors.size());
}

double unrest(const std::vector<DeformedFrame>& run, const std::vector<Found>& found)
{
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t t = 2; t < run.size(); ++t) {
        const std::vector<Eigen::Vector2d> before = errorsOf(run[t - 1], found[t - 1]);
        const std::vector<Eigen::Vector2d> now = errorsOf(run[t], found[t]);
        for (std::size_t i = 0; i < now.size(); ++i) {
            squares += (now[i] - before[i]).squaredNorm();
            count += 1.0;
        }
    }
    return std::sqrt(squares / count);
}

double coverageOf(const DeformedFrame& frame, const Found& found, const core::DeformableResult& deformed)
{
    const std::vector<Eigen::Vector2d> errors = errorsOf(frame, found);
    double inside = 0.0;
    std::size_t next = 0;
    for (const core::BranchMotion& motion : deformed.branches) {
        for (const Eigen::Matrix3d& covariance : motion.covariance) {
            const Eigen::Vector2d& e = errors[next++];
            inside += e.dot(covariance.topLeftCorner<2, 2>().inverse() * e) <= 5.991 ? 1.0 : 0.0;
        }
    }
    return inside / static_cast<double>(errors.size());
}

core::RegistrationInput inputOf(const core::VesselTree& tree, const DeformedFrame& frame,
                                const core::RigidTransform& start)
{
    core::RegistrationInput input;
    input.tree = tree;
    input.target = frame.view.target;
    input.camera = frame.view.camera;
    input.initialCameraFromPatient = start;
    return input;
}

Found foundIn(const core::VesselTree& tree, const core::RigidTransform& pose,
              const std::shared_ptr<const core::DeformableResult>& deformed)
{
    return {deformed ? core::deformedTreeAt(tree, *deformed, pose) : tree, pose};
}

void judgePeriod(const std::vector<core::TimedPose>& poses, const core::VesselTree& tree, Outcome& outcome)
{
    const core::RunPeriods periods = core::findPeriods(poses, core::centroidInPatient(tree));
    if (periods.breathMotion) {
        outcome.periodOffS = std::abs(periods.breathMotion->periodS - framesPerBreath / framesPerSecond);
    }
}

struct TrackedRun {
    std::vector<Found> frames;
    std::vector<core::TimedDeformation> deformations;   ///< of the frames that have one
};

core::DeformableView registeredFirst(const DeformedCase& first, const DeformedFrame& frame)
{
    core::RegistrationInput input = inputOf(first.tree, frame, first.views.front().nominal);
    input.initialCameraFromPatient = core::registerVessels(input).value().cameraFromPatient;
    return {input, input.initialCameraFromPatient, 0};
}

std::shared_ptr<const core::DeformableResult> deformationOf(const core::DeformableView& view)
{
    auto found = core::deformVessels(std::span(&view, 1)).value();
    return found.verdict == core::DeformationVerdict::Rigid
               ? nullptr
               : std::make_shared<const core::DeformableResult>(std::move(found));
}

TrackedRun followDeformed(const core::DeformableView& first, const std::vector<DeformedFrame>& run, Outcome& outcome)
{
    const core::VesselTree& tree = first.input.tree;
    const auto known = deformationOf(first);
    core::VesselTracker follower = core::VesselTracker::from(first.input, known, {}).value();
    TrackedRun followed;
    for (std::size_t t = 0; t < run.size(); ++t) {
        core::RigidTransform pose = first.rigidCameraFromPatient;
        std::shared_ptr<const core::DeformableResult> deformed = known;
        if (t > 0) {
            const core::ThreadStopwatch watch;
            const core::TrackedVessels found = follower.next(run[t].view.target).value();
            outcome.followedMs.push_back(watch.elapsedMs());
            outcome.lost += found.tracked.isTrustworthy ? 0.0 : 1.0 / static_cast<double>(run.size() - 1);
            pose = found.tracked.cameraFromPatient;
            deformed = found.deformed;
        }
        followed.frames.push_back(foundIn(tree, pose, deformed));
        if (deformed) {
            followed.deformations.push_back({static_cast<int>(t), pose, deformed});
        }
    }
    return followed;
}

/// Tracks rigidly, and deforms every frame from scratch at the tracked pose.
void followRigidly(const core::DeformableView& first, const std::vector<DeformedFrame>& run, Outcome& outcome)
{
    const core::VesselTree& tree = first.input.tree;
    const double share = 1.0 / static_cast<double>(run.size() - 1);
    core::VesselTracker follower = core::VesselTracker::from(first.input, nullptr, {}).value();
    for (std::size_t t = 1; t < run.size(); ++t) {
        const core::RigidTransform pose = follower.next(run[t].view.target).value().tracked.cameraFromPatient;
        outcome.rigidMm += share * meanError(run[t], {tree, pose});
        const core::DeformableView alone{inputOf(tree, run[t], pose), pose, 0};
        const core::ThreadStopwatch watch;
        const auto cold = core::deformVessels(std::span(&alone, 1)).value();
        outcome.coldMs.push_back(watch.elapsedMs());
        outcome.coldMm += share * meanError(run[t], {core::deformedTree(tree, cold), cold.cameraFromPatient});
    }
}

std::vector<Found> smoothed(const core::VesselTree& tree, const std::vector<DeformedFrame>& run,
                            const TrackedRun& followed, Outcome& outcome)
{
    std::vector<Found> smooth = followed.frames;
    const double share = 1.0 / std::max(1.0, static_cast<double>(followed.deformations.size()));
    for (const core::TimedDeformation& each : core::smoothOverTime(tree, followed.deformations)) {
        const auto t = static_cast<std::size_t>(each.frame);
        smooth[t] = foundIn(tree, each.rigidCameraFromPatient, each.deformed);
        outcome.coverage += share * coverageOf(run[t], smooth[t], *each.deformed);
    }
    return smooth;
}

double meanOfRun(const std::vector<DeformedFrame>& run, const std::vector<Found>& found)
{
    double sum = 0.0;
    for (std::size_t t = 1; t < run.size(); ++t) {
        sum += meanError(run[t], found[t]);
    }
    return sum / static_cast<double>(run.size() - 1);
}

Outcome runCase(const DeformedCase& first, const std::vector<DeformedFrame>& run)
{
    Outcome outcome;
    const core::DeformableView start = registeredFirst(first, run.front());
    const TrackedRun followed = followDeformed(start, run, outcome);
    followRigidly(start, run, outcome);
    const std::vector<Found> smooth = smoothed(first.tree, run, followed, outcome);
    outcome.followedMm = meanOfRun(run, followed.frames);
    outcome.smoothMm = meanOfRun(run, smooth);
    outcome.unrestMm = unrest(run, followed.frames);
    outcome.smoothUnrestMm = unrest(run, smooth);
    std::vector<core::TimedPose> timed;
    for (std::size_t t = 0; t < run.size(); ++t) {
        timed.push_back({static_cast<double>(t) / framesPerSecond, followed.frames[t].pose});
    }
    judgePeriod(timed, first.tree, outcome);
    return outcome;
}

double meanOver(const std::vector<Outcome>& outcomes, double Outcome::*value)
{
    double sum = 0.0;
    for (const Outcome& outcome : outcomes) {
        sum += outcome.*value / static_cast<double>(outcomes.size());
    }
    return sum;
}

double medianMs(const std::vector<Outcome>& outcomes, std::vector<double> Outcome::*times)
{
    std::vector<double> all;
    for (const Outcome& outcome : outcomes) {
        all.insert(all.end(), (outcome.*times).begin(), (outcome.*times).end());
    }
    return core::quantile(std::move(all), 0.5);
}

std::string periodText(const std::vector<Outcome>& outcomes)
{
    int found = 0;
    double worst = 0.0;
    for (const Outcome& outcome : outcomes) {
        found += outcome.periodOffS >= 0.0 ? 1 : 0;
        worst = std::max(worst, outcome.periodOffS);
    }
    return std::to_string(found) + " of " + std::to_string(outcomes.size()) + ", " + fixedText(worst, 2);
}

core::ResultTable::Row rowOf(const TrueMotion& motion, const std::vector<Outcome>& outcomes)
{
    return {
        {motion.name(), fixedText(meanOver(outcomes, &Outcome::rigidMm), 2),
         fixedText(meanOver(outcomes, &Outcome::coldMm), 2), fixedText(meanOver(outcomes, &Outcome::followedMm), 2),
         fixedText(meanOver(outcomes, &Outcome::smoothMm), 2), fixedText(meanOver(outcomes, &Outcome::coverage), 2),
         fixedText(meanOver(outcomes, &Outcome::unrestMm), 2),
         fixedText(meanOver(outcomes, &Outcome::smoothUnrestMm), 2),
         fixedText(100.0 * meanOver(outcomes, &Outcome::lost), 1), periodText(outcomes),
         fixedText(medianMs(outcomes, &Outcome::coldMs), 1), fixedText(medianMs(outcomes, &Outcome::followedMs), 1)},
        false};
}

}   // namespace

int main(int argc, char** argv)
{
    const benchmarks::Arguments arguments(argc, argv, usage);
    const auto cases = static_cast<std::uint64_t>(arguments.number("cases", 5));
    const auto frames = static_cast<std::size_t>(arguments.number("frames", 60));
    const std::string trees = arguments.text("trees", "real");
    core::ResultTable table;
    table.columns = {"truth",   "rigid mm",   "each cold",       "followed", "smoothed",
                     "c95",     "unrest mm",  "smoothed unrest", "lost %",   "period found, worst s",
                     "cold ms", "followed ms"};
    for (std::size_t row = 0; row < motions.size(); ++row) {
        std::vector<Outcome> outcomes;
        for (std::uint64_t number = 1; number <= cases; ++number) {
            const core::CounterRandom random = core::CounterRandom(131000 + 1000 * row).fork(number);
            const DeformedCase first = benchmarks::makeDeformedCase(
                benchmarks::centered(benchmarks::treeToDeform(trees, number)), motions[row], {0.0}, random.fork(1));
            outcomes.push_back(runCase(first, benchmarks::makeDeformedRun(first, motions[row], breathMm,
                                                                          framesPerBreath, frames, random.fork(2))));
            if (arguments.isSet("each")) {
                const Outcome& o = outcomes.back();
                std::printf("%s %d: rigid %.2f cold %.2f followed %.2f smoothed %.2f c95 %.2f\n",
                            motions[row].name().c_str(), static_cast<int>(number), o.rigidMm, o.coldMm, o.followedMm,
                            o.smoothMm, o.coverage);
                std::fflush(stdout);
            }
        }
        table.rows.push_back(rowOf(motions[row], outcomes));
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
