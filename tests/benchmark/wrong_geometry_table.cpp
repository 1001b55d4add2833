// Tests registration with a wrong geometry: whether the reported uncertainty covers the true error, and whether the
// error is named. Real cerebral arteries are the test set; the development set serves to choose thresholds.

#include "core/registration/pose/centroid_pose.h"
#include "core/registration/register_views.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "core/workflow/register_case.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/wrong_geometry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;

constexpr double inside95 = 12.592;   // 95 % quantile of χ² with six degrees of freedom
constexpr double sigmas95 = 1.96;

const char* const usage =
    "wrong_geometry_table\n"
    "  --family <name>   real: cerebral arteries of patients; development: trees made up (real)\n"
    "  --errors <list>   exact,sid,spacing,principal,mirrored,flipped,turned,upside-down (all)\n"
    "  --views <list>    one,two (both); of two, both have the wrong value\n"
    "  --trials <n>      for each tree and error (4)\n"
    "  --first <n>       number of the first trial (0)\n"
    "  --set <name>      none: the geometry counts as exact; estimate: where images contradict it they estimate it\n"
    "  --each            one line for each registration, too\n";

struct Answer {
    bool isTrusted = false;
    bool isNamed = false;   ///< by the message that should name the error
    bool isAlarmed = false;   ///< by any message about camera or frame
    bool isEstimated = false;   ///< a different camera was adopted
    double nees = 0.0;   ///< squared error over covariance, 6 degrees of freedom
    double depthErrorMm = 0.0;
    double depthStdMm = 0.0;
    double gain = 0.0;   ///< decrease of −2 log of the posterior by the estimated camera errors
    double focalOffPercent = 0.0;   ///< where the camera is estimated
    double timeMs = 0.0;
};

void hear(Answer& answer, const core::Messages& warnings, const NamedError& reported)
{
    for (const core::Message& warning : warnings) {
        const bool isAboutView = warning.id() == "views.in-view";
        const std::string_view id =
            isAboutView ? std::get<core::Messages>(warning.arguments().back()).front().id() : warning.id();
        answer.isNamed = answer.isNamed || (!reported.message.empty() && id.starts_with(reported.message));
        answer.isEstimated = answer.isEstimated || id == "camera.estimated";
        answer.isAlarmed = answer.isAlarmed || id.starts_with("camera.") || id.starts_with("frame.");
    }
}

void compare(Answer& answer, const ForeignCase& asked, const core::RigidTransform& pose,
             const core::PoseUncertainty& uncertainty)
{
    const Eigen::Vector3d centroid = core::centroidInPatient(asked.input.tree);
    const core::Vector6d error =
        core::stepBetween(core::aboutCentroid(pose, centroid), core::aboutCentroid(asked.truth, centroid));
    answer.nees = error.dot(uncertainty.covariance.ldlt().solve(error));
    answer.depthErrorMm = std::abs(error[5]);
    answer.depthStdMm = uncertainty.depthMm;
}

/// A case without images for these registration inputs, with their camera uncertainty in the options.
core::Case caseOf(const std::vector<core::RegistrationInput>& inputs, core::RegistrationOptions options)
{
    const core::CameraUncertainty spread = inputs.front().cameraUncertainty;
    options.geometry.spread = core::GeometrySpread::Given;
    options.geometry.focalPercent = 100.0 * spread.relativeFocalStd;
    options.geometry.principalPx = spread.principalPx;
    core::Case values;
    values.options = std::move(options);
    values.vessels.tree = std::make_shared<const core::VesselTree>(inputs.front().tree);
    values.views.clear();
    for (const core::RegistrationInput& input : inputs) {
        core::View& view = values.views.emplace_back();
        core::Angiogram empty;
        empty.frames.emplace_back(input.camera.width, input.camera.height);
        view.angiogram = std::make_shared<const core::Angiogram>(std::move(empty));
        view.frame = -1;
        view.target.centerline = std::make_shared<const core::Centerline2d>(input.target);
        view.geometry.cameraOverride = input.camera;
        view.initialCameraFromPatient = view.cameraFromPatient = input.initialCameraFromPatient;
    }
    return values;
}

/// The registration inputs with the geometry that is reported for them.
std::vector<core::RegistrationInput> reportedInputs(const std::vector<ForeignCase>& asked, const NamedError& reported,
                                                    std::uint64_t trial)
{
    std::vector<core::RegistrationInput> inputs;
    for (const ForeignCase& view : asked) {
        core::RegistrationInput& input = inputs.emplace_back(view.input);
        input.cameraUncertainty = spreadOfHeader(input.camera);
        spoil(input, reported.error, trial);
    }
    return inputs;
}

void hearRun(Answer& answer, const core::RegistrationResult& result, const ForeignCase& asked,
             const NamedError& reported)
{
    answer.isTrusted = result.trustworthy;
    answer.timeMs = result.time.totalMs;
    answer.gain = result.camera ? result.camera->gain : 0.0;
    hear(answer, result.warnings, reported);
    compare(answer, asked, result.cameraFromPatient, result.uncertainty);
}

Answer askEstimating(const std::vector<ForeignCase>& asked, const NamedError& reported, std::uint64_t trial,
                     const core::RegistrationOptions& options)
{
    Answer answer;
    if (const auto run = core::registerCase(caseOf(reportedInputs(asked, reported, trial), options))) {
        const double focalPx = core::cameraOf(run.value().session.shown()).value().fy;
        answer.focalOffPercent = 100.0 * std::abs(focalPx / asked.front().input.camera.fy - 1.0);
        hearRun(answer, run.value().result(), asked.front(), reported);
    }
    return answer;
}

Answer askOne(const ForeignCase& asked, const NamedError& reported, std::uint64_t trial,
              const core::RegistrationOptions& options)
{
    Answer answer;
    if (const auto result = core::registerVessels(reportedInputs({asked}, reported, trial).front(), options)) {
        hearRun(answer, result.value(), asked, reported);
    }
    return answer;
}

Answer askTogether(const std::vector<ForeignCase>& asked, const NamedError& reported, std::uint64_t trial,
                   const core::RegistrationOptions& options)
{
    Answer answer;
    const auto result = core::registerViews(reportedInputs(asked, reported, trial), options);
    if (!result) {
        return answer;
    }
    answer.isTrusted = result.value().trustworthy;
    answer.gain = result.value().cameras.empty() ? 0.0 : result.value().cameras.front().gain;
    hear(answer, result.value().warnings, reported);
    compare(answer, asked.front(), result.value().views.front().cameraFromPatient, result.value().uncertainty);
    return answer;
}

Answer ask(const std::vector<ForeignCase>& asked, const NamedError& reported, std::uint64_t trial,
           const core::RegistrationOptions& options)
{
    if (options.geometry.estimate) {
        return askEstimating(asked, reported, trial, options);
    }
    return asked.size() > 1 ? askTogether(asked, reported, trial, options)
                            : askOne(asked.front(), reported, trial, options);
}

std::vector<ForeignCase> questions(const std::vector<RootedTree>& trees, std::size_t tree, const std::string& views,
                                   std::uint64_t trial)
{
    if (views == "two") {
        const auto pair = makeForeignPair(trees, tree, trial);
        return {pair.begin(), pair.end()};
    }
    return {makeForeignCase(trees, tree, ForeignScene::WholeTree, trial)};
}

template <class Predicate>
std::string shareText(const std::vector<Answer>& answers, const Predicate& holds)
{
    return std::to_string(std::count_if(answers.begin(), answers.end(), holds)) + " of " +
           std::to_string(answers.size());
}

std::string medianText(const std::vector<Answer>& answers, double Answer::*value, int decimals)
{
    std::vector<double> values;
    for (const Answer& answer : answers) {
        values.push_back(answer.*value);
    }
    return core::fixedText(core::quantile(std::move(values), 0.5), decimals);
}

core::ResultTable::Row rowOf(const NamedError& reported, const std::string& views, const std::vector<Answer>& answers)
{
    const auto unless = [&](bool isMeaningless, std::string text) { return isMeaningless ? "–" : std::move(text); };
    const bool hasNoTruth = !hasTruth(reported.error);
    const auto isInside = [](const Answer& a) { return a.nees <= inside95; };
    const auto isDepthInside = [](const Answer& a) { return a.depthErrorMm <= sigmas95 * a.depthStdMm; };
    return {{views, std::string(reported.words), shareText(answers, [](const Answer& a) { return a.isTrusted; }),
             unless(hasNoTruth, shareText(answers, isInside)), unless(hasNoTruth, shareText(answers, isDepthInside)),
             unless(reported.message.empty(), shareText(answers, [](const Answer& a) { return a.isNamed; })),
             shareText(answers, [](const Answer& a) { return a.isAlarmed; }),
             shareText(answers, [](const Answer& a) { return a.isAlarmed || !a.isTrusted; }),
             shareText(answers, [](const Answer& a) { return a.isEstimated; }),
             unless(hasNoTruth, medianText(answers, &Answer::focalOffPercent, 1)),
             unless(hasNoTruth, medianText(answers, &Answer::depthErrorMm, 1)),
             unless(hasNoTruth, medianText(answers, &Answer::depthStdMm, 1)), medianText(answers, &Answer::gain, 1),
             medianText(answers, &Answer::timeMs, 0)},
            false};
}

void printAnswer(const NamedError& reported, const std::string& views, const RootedTree& tree, std::uint64_t trial,
                 const Answer& answer)
{
    std::printf("%s %-11s %-10s %2d  nees %8.2f  depth %6.1f ± %5.1f  gain %7.1f  %s%s%s  %6.0f ms\n", views.c_str(),
                std::string(reported.key).c_str(), tree.name.c_str(), static_cast<int>(trial), answer.nees,
                answer.depthErrorMm, answer.depthStdMm, answer.gain, answer.isTrusted ? "trusted" : "flagged",
                answer.isNamed ? " named" : "", answer.isAlarmed ? " word" : "", answer.timeMs);
    std::fflush(stdout);
}

std::vector<Answer> askAll(const std::vector<RootedTree>& trees, const NamedError& reported, const std::string& views,
                           const core::RegistrationOptions& options, const Arguments& arguments)
{
    const auto first = static_cast<std::uint64_t>(arguments.number("first", 0));
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 4));
    std::vector<Answer> answers;
    for (std::size_t tree = 0; tree < trees.size(); ++tree) {
        for (std::uint64_t trial = first; trial < first + trials; ++trial) {
            answers.push_back(ask(questions(trees, tree, views, trial), reported, trial, options));
            if (arguments.isSet("each")) {
                printAnswer(reported, views, trees[tree], trial, answers.back());
            }
        }
    }
    return answers;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::string family = arguments.text("family", "real");
    const std::vector<RootedTree> trees = treesOfFamily(family);
    if (trees.empty()) {
        return 1;
    }
    core::RegistrationOptions options;
    if (arguments.text("set", "") == "none") {
        options.geometry.spread = core::GeometrySpread::None;
    }
    options.geometry.estimate = arguments.text("set", "") == "estimate";
    const std::vector<std::string> wanted =
        arguments.list("errors", "exact,sid,spacing,principal,mirrored,flipped,turned,upside-down");
    core::ResultTable table;
    table.columns = {"views",    "wrong value",      "trusted",   "pose in 95 %", "depth in 95 %", "named",
                     "any word", "word or no trust", "estimated", "focal off %",  "depth off mm",  "depth σ mm",
                     "gain",     "median ms"};
    for (const std::string& views : arguments.list("views", "one,two")) {
        for (const NamedError& reported : geometryErrors) {
            const bool isWanted = std::find(wanted.begin(), wanted.end(), reported.key) != wanted.end();
            if (isWanted && (views == "one" || hasTruth(reported.error))) {
                table.rows.push_back(rowOf(reported, views, askAll(trees, reported, views, options, arguments)));
            }
        }
    }
    std::printf("%s trees, whole in the image, starts up to 15°, 30 mm across and 50 mm along the ray off\n\n%s\n",
                family == "real" ? "Real cerebral" : "Made-up", io::toPlainText(table).c_str());
    return 0;
}
