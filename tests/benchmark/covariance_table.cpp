// Tests whether the reported covariance is correct at any sampling density of the tree: simulated trees of 500 … 200
// 000 points, used without resampling, degraded targets, initial poses off by 2°/5 mm. NEES is eᵀΣ⁻¹e, with mean 6 when
// errors and Σ agree.

#include "core/evaluation/trial/projection_error.h"
#include "core/registration/registration.h"
#include "core/simulation/degrade_target.h"
#include "core/simulation/phantom.h"
#include "core/simulation/simulated_case.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"

#include <cstdio>
#include <numeric>

using namespace angiopose;

namespace {

using core::fixedText;

constexpr std::uint64_t trees = 10;

const char* const usage =
    "covariance_table\n"
    "  --points <list>   points of the tree (500,2000,20000,200000)\n"
    "  --trials <n>      registrations for each (100)\n";

struct Outcome {
    double errorMm = 0.0;   ///< mean reprojection distance over the tree
    double depthStdMm = 0.0;
    double nees = 0.0;
};

Outcome registerOnce(const core::Phantom& phantom, std::uint64_t trial)
{
    core::CounterRandom random(7000 + trial);
    const Eigen::Vector3d centroid = core::centroidInPatient(phantom.tree);
    core::RegistrationInput input;
    input.tree = phantom.tree;
    input.camera = phantom.camera;
    input.initialCameraFromPatient =
        core::perturbAboutCentroid(phantom.trueCameraFromPatient, centroid, 2.0, 5.0, random);
    input.target = core::addTracingErrors(phantom.exactTarget, phantom.camera, random);
    core::RegistrationOptions options;
    options.resample = false;
    const core::RegistrationResult result = core::registerVessels(input, options).value();
    const core::PosePair poses{result.cameraFromPatient, phantom.trueCameraFromPatient};
    return {core::projectionError(phantom.tree, phantom.camera, poses).meanMm, result.uncertainty.depthMm,
            core::normalizedErrorSquared(core::errorAboutCentroid(centroid, poses), result.uncertainty.covariance)};
}

std::vector<Outcome> registerAll(int points, std::uint64_t trials)
{
    std::vector<Outcome> outcomes;
    for (std::uint64_t tree = 0; tree < trees; ++tree) {
        const core::Phantom phantom = core::makePhantom(1000 + tree, points);
        for (std::uint64_t trial = tree; trial < trials; trial += trees) {
            outcomes.push_back(registerOnce(phantom, trial));
        }
    }
    return outcomes;
}

std::vector<double> all(const std::vector<Outcome>& outcomes, double Outcome::*value)
{
    std::vector<double> values;
    for (const Outcome& outcome : outcomes) {
        values.push_back(outcome.*value);
    }
    return values;
}

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}   // namespace

int main(int argc, char** argv)
{
    const benchmarks::Arguments arguments(argc, argv, usage);
    const auto trials = static_cast<std::uint64_t>(arguments.number("trials", 100));
    core::ResultTable table;
    table.columns = {"points", "mean error mm", "depth std mm", "NEES", "median", "p95"};
    for (const std::string& points : arguments.list("points", "500,2000,20000,200000")) {
        const std::vector<Outcome> outcomes = registerAll(std::stoi(points), trials);
        const std::vector<double> nees = all(outcomes, &Outcome::nees);
        table.rows.push_back(
            {{points, fixedText(mean(all(outcomes, &Outcome::errorMm)), 3),
              fixedText(core::quantile(all(outcomes, &Outcome::depthStdMm), 0.5), 2), fixedText(mean(nees), 1),
              fixedText(core::quantile(nees, 0.5), 1), fixedText(core::quantile(nees, 0.95), 1)},
             false});
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
    return 0;
}
