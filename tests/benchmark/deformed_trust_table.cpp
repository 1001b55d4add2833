// Tests what the rigid result reports where the vessels are deformed: whether errors are flagged, whether its
// covariance covers them, and the time it takes. Real cerebral arteries are the test set; the development set serves to
// choose thresholds.

#include "core/evaluation/trial/projection_error.h"
#include "core/registration/register_views.h"
#include "core/registration/registration.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/support/stopwatch.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/deformed_cases.h"
#include "tests/benchmark/foreign/trees.h"
#include "tests/benchmark/known_pose.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

using namespace angiopose;

namespace {

using namespace benchmarks;
using core::fixedText;
using Form = TrueMotion::Form;

constexpr double goodMm = 2.0;
constexpr double grossMm = 5.0;
constexpr double inside95 = 12.592;   // 95 % quantile of χ² with six degrees of freedom

const char* const usage =
    "deformed_trust_table\n"
    "  --family <name>   real: cerebral arteries of patients; development: trees made up (real)\n"
    "  --rows <list>     numbers of rows, counted from 0 (all)\n"
    "  --trials <n>      for each tree and row (4)\n"
    "  --first <n>       number of the first trial (0)\n"
    "  --turn <deg>      a second view, turned by so much (0: one view)\n"
    "  --set <never|auto>  option deformable (auto)\n"
    "  --each            one line for each registration, too\n";

/// One row of the table: the motion of the vessels, or an image that shows another patient's vessels.
struct Question {
    TrueMotion motion;
    bool isImpossible = false;

    std::string name() const { return isImpossible ? "another tree" : motion.name(); }
};

const std::vector<Question> questions{{{Form::None, 0, 0}},   {{Form::Field, 40, 1}},     {{Form::Field, 40, 2}},
                                      {{Form::Field, 40, 3}}, {{Form::Field, 20, 1}},     {{Form::Field, 20, 2}},
                                      {{Form::Field, 20, 3}}, {{Form::Field, 80, 3}},     {{Form::Field, 40, 5}},
                                      {{Form::Waves, 40, 3}}, {{Form::Breathing, 0, 10}}, {{Form::Wire, 0, 6}},
                                      {{Form::Half, 0, 8}},   {{Form::None, 0, 0}, true}};

struct Answer {
    double errorMm = 0.0;   ///< mean over all points: in the image plane for one view, in 3-D for several
    bool isTrusted = false;
    bool isDeformed = false;   ///< the result reports a deformation
    double nees = 0.0;   ///< relative to the rigid pose nearest to the deformed tree in 3-D
    double inPlaneStdMm = 0.0;
    double timeMs = 0.0;
    core::Messages warnings;
};

/// Mean distance of the tree's points at the pose from their true positions.
double meanErrorMm(const DeformedCase& deformedCase, const core::RigidTransform& pose)
{
    const core::RigidTransform& truth = deformedCase.views.front().truth;
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t b = 0; b < deformedCase.tree.branches.size(); ++b) {
        for (std::size_t i = 0; i < deformedCase.tree.branches[b].pointsInPatient.size(); ++i) {
            const Eigen::Vector3d found = pose * deformedCase.tree.branches[b].pointsInPatient[i];
            const Eigen::Vector3d place = truth * deformedCase.deformed.branches[b].pointsInPatient[i];
            sum += deformedCase.views.size() > 1
                       ? (found - place).norm()
                       : place.z() * (found.head<2>() / found.z() - place.head<2>() / place.z()).norm();
            count += 1.0;
        }
    }
    return sum / count;
}

std::vector<core::RegistrationInput> inputsOf(const DeformedCase& deformedCase)
{
    std::vector<core::RegistrationInput> inputs;
    for (const DeformedView& view : deformedCase.views) {
        core::RegistrationInput input;
        input.tree = deformedCase.tree;
        input.target = view.target;
        input.camera = view.camera;
        input.initialCameraFromPatient = view.nominal;
        inputs.push_back(std::move(input));
    }
    return inputs;
}

void compare(Answer& answer, const DeformedCase& deformedCase, const core::RigidTransform& pose,
             const core::PoseUncertainty& uncertainty)
{
    const Eigen::Vector3d centroid = core::centroidInPatient(deformedCase.tree);
    answer.errorMm = meanErrorMm(deformedCase, pose);
    answer.nees = core::normalizedErrorSquared(
        core::errorAboutCentroid(centroid, {pose, nearestPoseInSpace(deformedCase)}), uncertainty.covariance);
    answer.inPlaneStdMm = uncertainty.inPlaneMm;
}

Answer ask(const DeformedCase& deformedCase, const core::RegistrationOptions& options)
{
    const std::vector<core::RegistrationInput> inputs = inputsOf(deformedCase);
    Answer answer;
    const core::ThreadStopwatch watch;
    if (inputs.size() == 1) {
        const core::RegistrationResult result = core::registerVessels(inputs.front(), options).value();
        answer.timeMs = watch.elapsedMs();
        answer.isTrusted = result.trustworthy;
        answer.warnings = result.warnings;
        compare(answer, deformedCase, result.cameraFromPatient, result.uncertainty);
    } else {
        const core::MultiViewResult result = core::registerViews(inputs, options).value();
        answer.timeMs = watch.elapsedMs();
        answer.isTrusted = result.trustworthy;
        answer.warnings = result.warnings;
        compare(answer, deformedCase, result.views.front().cameraFromPatient, result.uncertainty);
    }
    answer.isDeformed = std::ranges::any_of(
        answer.warnings, [](const core::Message& warning) { return warning.id().starts_with("bend."); });
    return answer;
}

DeformedCase caseOf(const Question& question, const std::vector<RootedTree>& trees, std::size_t tree,
                    std::uint64_t trial, const std::vector<double>& turns, core::CounterRandom random)
{
    const core::CounterRandom own = random.fork(100 * tree + trial);
    DeformedCase made = makeDeformedCase(centered(trees[tree].tree), question.motion, turns, own);
    if (question.isImpossible) {
        const core::VesselTree other = centered(trees[(tree + 1 + trial) % trees.size()].tree);
        const DeformedCase shown = makeDeformedCase(trees.size() > 1 ? other : made.tree, question.motion, turns, own);
        for (std::size_t view = 0; view < turns.size(); ++view) {
            made.views[view].target = shown.views[view].target;
        }
    }
    return made;
}

double mean(const std::vector<Answer>& answers, double Answer::*value)
{
    return std::accumulate(answers.begin(), answers.end(), 0.0,
                           [&](double sum, const Answer& answer) { return sum + answer.*value; }) /
           static_cast<double>(answers.size());
}

double quantileOf(const std::vector<Answer>& answers, double Answer::*value, double share)
{
    std::vector<double> values;
    for (const Answer& answer : answers) {
        values.push_back(answer.*value);
    }
    return core::quantile(values, share);
}

/// "3 of 4": the second predicate holds for 3 of the 4 answers for which the first holds.
template <class Whole, class Part>
std::string shareText(const std::vector<Answer>& answers, const Whole& isMeant, const Part& holds)
{
    const auto meant = std::ranges::count_if(answers, isMeant);
    const auto held = std::ranges::count_if(answers, [&](const Answer& a) { return isMeant(a) && holds(a); });
    return meant > 0 ? std::to_string(held) + " of " + std::to_string(meant) : "–";
}

core::ResultTable::Row rowOf(const std::string& name, bool isImpossible, const std::vector<Answer>& answers)
{
    const auto isFlagged = [](const Answer& a) { return !a.isTrusted; };
    const auto isGood = [&](const Answer& a) { return !isImpossible && a.errorMm < goodMm; };
    const auto isModerate = [&](const Answer& a) {
        return !isImpossible && a.errorMm >= goodMm && a.errorMm <= grossMm;
    };
    const auto isGross = [&](const Answer& a) { return !isImpossible && a.errorMm > grossMm; };
    const auto isAny = [](const Answer&) { return true; };
    const auto unless = [&](std::string text) { return isImpossible ? std::string("–") : text; };
    return {
        {name, unless(fixedText(mean(answers, &Answer::errorMm), 2)),
         unless(fixedText(quantileOf(answers, &Answer::inPlaneStdMm, 0.5), 2)), shareText(answers, isGood, isFlagged),
         shareText(answers, isModerate, isFlagged), shareText(answers, isGross, isFlagged),
         isImpossible ? shareText(answers, isAny, isFlagged) : std::string("–"),
         shareText(answers, isAny, [](const Answer& a) { return a.isDeformed; }),
         unless(fixedText(mean(answers, &Answer::nees), 1)),
         unless(fixedText(quantileOf(answers, &Answer::nees, 0.5), 1)),
         unless(shareText(answers, isAny, [](const Answer& a) { return a.nees <= inside95; })),
         fixedText(quantileOf(answers, &Answer::timeMs, 0.5), 0),
         fixedText(quantileOf(answers, &Answer::timeMs, 1.0), 0)},
        false};
}

void printAnswer(const Question& question, const std::string& tree, std::uint64_t trial, const Answer& answer)
{
    std::printf("%-20s %-10s %2d  %6.3f mm  σ %5.2f  NEES %7.1f  %-7s %s %4.0f ms ", question.name().c_str(),
                tree.c_str(), static_cast<int>(trial), answer.errorMm, answer.inPlaneStdMm, answer.nees,
                answer.isTrusted ? "trusted" : "flagged", answer.isDeformed ? "bent " : "rigid", answer.timeMs);
    for (const core::Message& warning : answer.warnings) {
        std::printf(" [%s]", std::string(warning.id()).c_str());
    }
    std::printf("\n");
    std::fflush(stdout);
}

std::vector<std::size_t> chosenRows(const Arguments& arguments)
{
    std::vector<std::size_t> rows;
    for (const std::string& row : arguments.list("rows", "")) {
        if (!row.empty()) {
            rows.push_back(static_cast<std::size_t>(std::stoi(row)));
        }
    }
    if (rows.empty()) {
        rows.resize(questions.size());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
    }
    return rows;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::vector<RootedTree> trees = treesOfFamily(arguments.text("family", "real"));
    if (trees.empty()) {
        return 1;
    }
    const auto first = static_cast<std::uint64_t>(arguments.number("first", 0));
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 4));
    const double turnDeg = arguments.number("turn", 0.0);
    const std::vector<double> turns = turnDeg == 0.0 ? std::vector{0.0} : std::vector{0.0, turnDeg};
    core::RegistrationOptions options;
    options.deformation = arguments.text("set", "auto") == "never" ? core::Deformation::Off : core::Deformation::Auto;
    core::ResultTable table;
    table.columns = {"truth",     "mean mm", "σ mm",       "false alarms", "flagged 2–5", "flagged > 5", "impossible",
                     "said bent", "NEES",    "its median", "inside 95 %",  "median ms",   "longest ms"};
    std::vector<Answer> possible;
    for (const std::size_t row : chosenRows(arguments)) {
        const Question& question = questions[row];
        std::vector<Answer> answers;
        for (std::size_t tree = 0; tree < trees.size(); ++tree) {
            for (std::uint64_t trial = first; trial < first + trials; ++trial) {
                const core::CounterRandom random(91000 + 1000 * row);
                answers.push_back(ask(caseOf(question, trees, tree, trial, turns, random), options));
                if (arguments.isSet("each")) {
                    printAnswer(question, trees[tree].name, trial, answers.back());
                }
            }
        }
        table.rows.push_back(rowOf(question.name(), question.isImpossible, answers));
        if (!question.isImpossible) {
            possible.insert(possible.end(), answers.begin(), answers.end());
        }
    }
    table.rows.push_back(rowOf("all but impossible", false, possible));
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
