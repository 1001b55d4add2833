// Measures the benefit of deformable over rigid registration on trees with a known deformation: mean distance in the
// image plane over all points of the tree (mm at the object) for the best rigid pose that truth allows, our rigid
// registration, and the deformed tree; the consistency of the covariance of every point; time. With several views:
// distance in 3-D.

#include "core/registration/deformable/deformed_tree.h"
#include "core/registration/register_views.h"
#include "core/registration/registration.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/support/stopwatch.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/deformed_cases.h"
#include "tests/benchmark/graph_trees.h"
#include "tests/benchmark/known_pose.h"

#include <cstdio>
#include <numeric>

using namespace angiopose;
using benchmarks::DeformedCase;
using benchmarks::DeformedView;
using benchmarks::TrueMotion;

namespace {

using core::fixedText;
using Form = TrueMotion::Form;

const char* const usage =
    "deformable_table\n"
    "  --cases <n>       per row (10)\n"
    "  --trees <which>   real: cerebral trees, to judge; grown: simulated ones, to choose options (real)\n"
    "  --rows <list>     numbers of rows, counted from 0 (all)\n"
    "  --turn <deg>      a second view, turned by so much (0: one view)\n"
    "  --seed <n>        of the first case (1)\n"
    "  --each            a line for every case too\n";

const std::vector<TrueMotion> motions{
    {Form::None, 0, 0},   {Form::Field, 80, 3}, {Form::Field, 80, 5}, {Form::Field, 40, 1},
    {Form::Field, 40, 2}, {Form::Field, 40, 3}, {Form::Field, 40, 5}, {Form::Field, 20, 1},
    {Form::Field, 20, 2}, {Form::Field, 20, 3}, {Form::Field, 20, 5}, {Form::Breathing, 0, 10},
    {Form::Wire, 0, 6},   {Form::Waves, 40, 3}, {Form::Waves, 20, 2}, {Form::Half, 0, 8}};

struct Errors {
    double mean = 0.0;
    double missing = 0.0;   ///< of branches that are unopacified in the images
};

struct Outcome {
    Errors best, rigid, deformed;
    double coverage = 0.0;
    double nees = 0.0;   ///< per degree of freedom
    core::DeformableResult result;
    double rigidMs = 0.0;
    double deformedMs = 0.0;
};

/// Difference of a point from its true position: in the image plane for one view, mm at its depth; in 3-D for several
/// views.
Eigen::Vector3d difference(const DeformedCase& deformedCase, const core::RigidTransform& pose,
                           const Eigen::Vector3d& point, const Eigen::Vector3d& truePoint)
{
    const DeformedView& view = deformedCase.views.front();
    const Eigen::Vector3d found = pose * point;
    const Eigen::Vector3d truth = view.truth * truePoint;
    if (deformedCase.views.size() > 1) {
        return found - truth;
    }
    const Eigen::Vector2d apart = truth.z() * (found.head<2>() / found.z() - truth.head<2>() / truth.z());
    return {apart.x(), apart.y(), 0.0};
}

Errors errorsOf(const DeformedCase& deformedCase, const core::RigidTransform& pose, const core::VesselTree& tree)
{
    Errors errors;
    double count = 0.0;
    double missing = 0.0;
    for (std::size_t b = 0; b < tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < tree.branches[b].pointsInPatient.size(); ++i) {
            const double error = difference(deformedCase, pose, tree.branches[b].pointsInPatient[i],
                                            deformedCase.deformed.branches[b].pointsInPatient[i])
                                     .norm();
            errors.mean += error;
            count += 1.0;
            if (deformedCase.isMissing[b]) {
                errors.missing += error;
                missing += 1.0;
            }
        }
    }
    errors.mean /= count;
    errors.missing /= std::max(1.0, missing);
    return errors;
}

/// Assesses the covariance of `difference`.
void judgeCovariance(const DeformedCase& deformedCase, const core::VesselTree& deformed, Outcome& outcome)
{
    const bool isFlat = deformedCase.views.size() == 1;
    const double limit = isFlat ? 5.991 : 7.815;
    double inside = 0.0;
    double count = 0.0;
    for (std::size_t b = 0; b < deformed.branches.size(); ++b) {
        for (std::size_t i = 0; i < deformed.branches[b].pointsInPatient.size(); ++i) {
            const Eigen::Vector3d e =
                difference(deformedCase, outcome.result.cameraFromPatient, deformed.branches[b].pointsInPatient[i],
                           deformedCase.deformed.branches[b].pointsInPatient[i]);
            const Eigen::Matrix3d& covariance = outcome.result.branches[b].covariance[i];
            const double squares = isFlat ? e.head<2>().dot(covariance.topLeftCorner<2, 2>().inverse() * e.head<2>())
                                          : e.dot(covariance.inverse() * e);
            inside += squares <= limit ? 1.0 : 0.0;
            outcome.nees += squares / (isFlat ? 2.0 : 3.0);
            count += 1.0;
        }
    }
    outcome.coverage = inside / count;
    outcome.nees /= count;
}

core::RegistrationInput inputOf(const DeformedCase& deformedCase, const DeformedView& view)
{
    core::RegistrationInput input;
    input.tree = deformedCase.tree;
    input.target = view.target;
    input.camera = view.camera;
    input.initialCameraFromPatient = view.nominal;
    return input;
}

std::vector<core::RigidTransform> registerRigidly(const std::vector<core::RegistrationInput>& inputs)
{
    if (inputs.size() == 1) {
        return {core::registerVessels(inputs.front()).value().cameraFromPatient};
    }
    const core::MultiViewResult joint =
        core::registerViews(inputs, {},
                            {std::vector<core::RelativePoseStd>(inputs.size(), {0.02, {0.05, 0.05, 0.05}}), {}})
            .value();
    std::vector<core::RigidTransform> poses;
    for (std::size_t k = 0; k < inputs.size(); ++k) {   // the geometry is exact here
        poses.push_back(inputs[k].initialCameraFromPatient * inputs.front().initialCameraFromPatient.inverse() *
                        joint.views.front().cameraFromPatient);
    }
    return poses;
}

Outcome runCase(const DeformedCase& deformedCase)
{
    Outcome outcome;
    std::vector<core::RegistrationInput> inputs;
    std::vector<core::DeformableView> views;
    for (const DeformedView& view : deformedCase.views) {
        inputs.push_back(inputOf(deformedCase, view));
    }
    core::ThreadStopwatch rigidWatch;
    const std::vector<core::RigidTransform> rigid = registerRigidly(inputs);
    outcome.rigidMs = rigidWatch.elapsedMs();
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        views.push_back({inputs[k], rigid[k], 0});
    }
    core::ThreadStopwatch deformedWatch;
    outcome.result = core::deformVessels(views).value();
    outcome.deformedMs = deformedWatch.elapsedMs();
    outcome.best = errorsOf(deformedCase, benchmarks::bestRigidPose(deformedCase), deformedCase.tree);
    outcome.rigid = errorsOf(deformedCase, rigid.front(), deformedCase.tree);
    const core::VesselTree deformed = core::deformedTree(deformedCase.tree, outcome.result);
    outcome.deformed = errorsOf(deformedCase, outcome.result.cameraFromPatient, deformed);
    judgeCovariance(deformedCase, deformed, outcome);
    return outcome;
}

template <class Value>
double meanOver(const std::vector<Outcome>& outcomes, const Value& value)
{
    return std::accumulate(outcomes.begin(), outcomes.end(), 0.0,
                           [&](double sum, const Outcome& outcome) { return sum + value(outcome); }) /
           static_cast<double>(outcomes.size());
}

std::string textOf(const Outcome& o)
{
    return "best " + fixedText(o.best.mean, 3) + " rigid " + fixedText(o.rigid.mean, 3) + " bent " +
           fixedText(o.deformed.mean, 3) + " missing " + fixedText(o.deformed.missing, 3) + " c95 " +
           fixedText(o.coverage, 2) + " nees " + fixedText(o.nees, 2) + " gain " +
           fixedText(o.result.logEvidenceGain, 1) + " " + std::string(core::toText(o.result.verdict)) + " spread " +
           fixedText(o.result.spreadMm, 2) + " explained " + fixedText(o.result.explainedShare, 2) + " noise " +
           fixedText(o.result.noisePx, 2) + " ms " + fixedText(o.deformedMs, 0);
}

core::ResultTable::Row rowOf(const TrueMotion& motion, const std::vector<Outcome>& outcomes)
{
    int deformed = 0;
    int unsure = 0;
    int worse = 0;
    std::vector<double> gains;
    std::vector<double> times;
    for (const Outcome& outcome : outcomes) {
        deformed += outcome.result.verdict == core::DeformationVerdict::Deformed ? 1 : 0;
        unsure += outcome.result.verdict == core::DeformationVerdict::Unsure ? 1 : 0;
        worse += outcome.deformed.mean > outcome.rigid.mean * (motion.form == Form::None ? 1.05 : 1.0) ? 1 : 0;
        gains.push_back(outcome.result.logEvidenceGain);
        times.push_back(outcome.deformedMs);
    }
    return {
        {motion.name(), fixedText(meanOver(outcomes, [](const Outcome& o) { return o.best.mean; }), 2),
         fixedText(meanOver(outcomes, [](const Outcome& o) { return o.rigid.mean; }), 2),
         fixedText(meanOver(outcomes, [](const Outcome& o) { return o.deformed.mean; }), 3),
         fixedText(meanOver(outcomes, [](const Outcome& o) { return o.deformed.missing; }), 2),
         fixedText(meanOver(outcomes, [](const Outcome& o) { return o.coverage; }), 2),
         fixedText(meanOver(outcomes, [](const Outcome& o) { return o.nees; }), 2),
         fixedText(core::quantile(gains, motion.form == Form::None ? 1.0 : 0.0), 1),
         std::to_string(outcomes.size() - static_cast<std::size_t>(deformed + unsure)) + "/" +
             std::to_string(deformed) + "/" + std::to_string(unsure),
         std::to_string(worse) + " of " + std::to_string(outcomes.size()), fixedText(core::quantile(times, 0.5), 0)},
        false};
}

std::vector<std::size_t> chosenRows(const benchmarks::Arguments& arguments)
{
    std::vector<std::size_t> rows;
    for (const std::string& row : arguments.list("rows", "")) {
        if (!row.empty()) {
            rows.push_back(static_cast<std::size_t>(std::stoi(row)));
        }
    }
    for (std::size_t k = 0; rows.empty() || (rows.size() == k && k < motions.size()); ++k) {
        rows.push_back(k);
    }
    return rows;
}

}   // namespace

int main(int argc, char** argv)
{
    const benchmarks::Arguments arguments(argc, argv, usage);
    const auto cases = static_cast<std::uint64_t>(arguments.number("cases", 10));
    const auto seed = static_cast<std::uint64_t>(arguments.number("seed", 1));
    const double turnDeg = arguments.number("turn", 0.0);
    const std::string trees = arguments.text("trees", "real");
    std::vector<double> turns{0.0};
    if (turnDeg != 0.0) {
        turns.push_back(turnDeg);
    }
    core::ResultTable table;
    table.columns = {"truth", "best rigid",        "rigid", "bent", "missing", "c95", "NEES/n",
                     "gain",  "rigid/bent/unsure", "worse", "ms"};
    for (const std::size_t row : chosenRows(arguments)) {
        std::vector<Outcome> outcomes;
        for (std::uint64_t k = 0; k < cases; ++k) {
            const std::uint64_t number = seed + k;
            const core::CounterRandom random = core::CounterRandom(77000 + 1000 * row).fork(number);
            outcomes.push_back(runCase(
                benchmarks::makeDeformedCase(benchmarks::treeToDeform(trees, number), motions[row], turns, random)));
            if (arguments.isSet("each")) {
                std::printf("%s %d: %s\n", motions[row].name().c_str(), static_cast<int>(number),
                            textOf(outcomes.back()).c_str());
                std::fflush(stdout);
            }
        }
        table.rows.push_back(rowOf(motions[row], outcomes));
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
