#include "tests/benchmark/phantom_floor.h"

#include "core/simulation/deform_tree.h"
#include "core/simulation/simulated_case.h"
#include "core/support/format_number.h"
#include "core/support/quantile.h"
#include "io/evaluation/table_text.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

using core::fixedText;

constexpr double seenWithinPx = 8.0;   // limit for the part of a branch that the real view shows
constexpr double shapeStdsMm[] = {0.0, 0.2, 0.4, 0.5, 0.6, 0.8};   // per axis
constexpr double gantryStdsDeg[] = {0.0, 0.3, 0.5};   // per axis and view
constexpr double aimedMedianDeg = 0.7;

bool isSeen(const Eigen::Vector2d& pixel, const core::Centerline2d& traced)
{
    for (const core::Curve2d& curve : traced.curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            if ((point - pixel).norm() < seenWithinPx) {
                return true;
            }
        }
    }
    return false;
}

/// Pieces of the projected tree that the real view also shows.
core::Centerline2d seenPart(const core::Centerline2d& projected, const core::Centerline2d& traced)
{
    core::Centerline2d seen;
    for (const core::Curve2d& curve : projected.curves) {
        bool follows = false;
        for (const Eigen::Vector2d& pixel : curve.pointsPx) {
            const bool isShown = isSeen(pixel, traced);
            if (isShown && !follows) {
                seen.curves.push_back({static_cast<int>(seen.curves.size()), {}, {}});
            }
            if (isShown) {
                seen.curves.back().pointsPx.push_back(pixel);
            }
            follows = isShown;
        }
    }
    return seen;
}

/// The four views of a phantom whose true shape differs slightly from the tree, at the poses found in the real views.
std::vector<core::RegistrationInput> simulatedViews(const std::vector<PhantomView>& views, double shapeStdMm,
                                                    core::CounterRandom random)
{
    const core::VesselTree warped = core::deformed(views.front().input.tree, shapeStdMm, random);
    std::vector<core::RegistrationInput> inputs;
    for (const PhantomView& view : views) {
        inputs.push_back(view.input);
        inputs.back().target =
            seenPart(core::projectTree(warped, view.input.camera, view.result.cameraFromPatient), view.input.target);
    }
    return inputs;
}

struct Simulated {
    std::vector<std::vector<Eigen::Matrix3d>> rotations;   ///< by trial and view
    std::vector<double> medianPx;
};

Simulated simulate(const std::vector<PhantomView>& views, double shapeStdMm, int trials,
                   const core::CounterRandom& random)
{
    Simulated simulated;
    for (int trial = 0; trial < trials; ++trial) {
        double medianPx = 0.0;
        auto rotations =
            rotationsOf(simulatedViews(views, shapeStdMm, random.fork(static_cast<std::uint64_t>(trial))), medianPx);
        if (!rotations.empty()) {
            simulated.rotations.push_back(std::move(rotations));
            simulated.medianPx.push_back(medianPx);
        }
    }
    return simulated;
}

/// Rotations that the headers would report for slightly wrong gantry angles.
std::vector<Eigen::Matrix3d> reportedRotations(const std::vector<PhantomView>& views, double stdDeg,
                                               core::CounterRandom random)
{
    std::vector<Eigen::Matrix3d> reported = registeredRotations(views);
    for (Eigen::Matrix3d& rotation : reported) {
        const double x = random.normal();
        const double y = random.normal();
        rotation = core::expSo3(stdDeg * std::numbers::pi / 180.0 * Eigen::Vector3d(x, y, 0.0)) * rotation;
    }
    return reported;
}

std::string spreadText(const std::vector<double>& values, const char* unit)
{
    const std::vector<double> shares = core::quantiles(values, {0.05, 0.5, 0.95});
    return fixedText(shares[1], 2) + unit + " [" + fixedText(shares[0], 2) + ", " + fixedText(shares[2], 2) + "]";
}

core::ResultTable::Row rowOf(const std::vector<PhantomView>& views, double shapeStdMm, double gantryStdDeg,
                             const Simulated& simulated, const core::CounterRandom& random)
{
    std::vector<double> mediansDeg;
    std::vector<double> largestDeg;
    for (std::size_t trial = 0; trial < simulated.rotations.size(); ++trial) {
        const auto pairs =
            pairsOf(simulated.rotations[trial], reportedRotations(views, gantryStdDeg, random.fork(trial).fork(1)));
        mediansDeg.push_back(medianDifferenceDeg(pairs));
        largestDeg.push_back(largestDifferenceDeg(pairs));
    }
    const auto reached =
        std::count_if(mediansDeg.begin(), mediansDeg.end(), [](double deg) { return deg <= aimedMedianDeg; });
    return {{fixedText(shapeStdMm, 1) + " mm", fixedText(gantryStdDeg, 1) + "°", spreadText(simulated.medianPx, " px"),
             spreadText(mediansDeg, "°"), spreadText(largestDeg, "°"),
             std::to_string(reached) + " of " + std::to_string(mediansDeg.size())},
            false};
}

}   // namespace

std::vector<Eigen::Matrix3d> rotationsOf(const std::vector<core::RegistrationInput>& inputs, double& medianPx)
{
    std::vector<Eigen::Matrix3d> rotations;
    medianPx = 0.0;
    for (const core::RegistrationInput& input : inputs) {
        const auto result = core::registerVessels(input);
        if (!result) {
            return {};
        }
        rotations.push_back(result.value().cameraFromPatient.rotation);
        medianPx += result.value().metrics.medianPx / static_cast<double>(inputs.size());
    }
    return rotations;
}

void printFloor(const std::vector<PhantomView>& views, int trials, std::uint64_t seed)
{
    const core::CounterRandom random(seed);
    core::ResultTable table;
    table.columns = {"shape error", "gantry", "median px", "median difference", "largest", "median at most 0.7°"};
    for (const double shapeStdMm : shapeStdsMm) {
        const Simulated simulated = simulate(views, shapeStdMm, trials, random);
        for (const double gantryStdDeg : gantryStdsDeg) {
            table.rows.push_back(rowOf(views, shapeStdMm, gantryStdDeg, simulated, random));
        }
    }
    std::printf(
        "What to expect of a tree off the vessel's shape by a smooth random error (1-σ per axis, 40 mm long), and of\n"
        "gantries off their headers (1-σ per axis): medians of %d simulated phantoms, [5, 95 %% quantiles]\n\n%s\n",
        trials, io::toPlainText(table).c_str());
}

}   // namespace angiopose::benchmarks
