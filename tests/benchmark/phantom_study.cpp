// Analyzes what limits the agreement of the phantom's registered views with the angles in their headers
// (phantom_table): the difference of each view, the cost of enforcing the header's angles, the effect of single
// branches, and the disagreement to be expected from a tree that differs slightly from the vessel's shape.

#include "core/registration/register_views.h"
#include "core/support/format_number.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/phantom_floor.h"
#include "tests/benchmark/phantom_views.h"

#include <algorithm>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;
using core::fixedText;

const char* const usage =
    "phantom_study [folder with IM1.angiopose … IM4.angiopose]\n"
    "  --trials <n>      simulated phantoms for each size of the shape error (100)\n"
    "  --seed <n>        (1)\n";

Eigen::Vector3d centroidInCamera(const PhantomView& view)
{
    return view.result.cameraFromPatient * core::centroidInPatient(view.input.tree);
}

/// The rotation of the patient that the header's angles leave undetermined, estimated from all views together.
Eigen::Matrix3d commonTurn(const std::vector<PhantomView>& views)
{
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const PhantomView& view : views) {
        sum += view.headerRotation.transpose() * view.result.cameraFromPatient.rotation;
    }
    return core::nearestRotation(sum);
}

std::string vectorText(const Eigen::Vector3d& vector, int decimals)
{
    return fixedText(vector.x(), decimals) + " / " + fixedText(vector.y(), decimals) + " / " +
           fixedText(vector.z(), decimals);
}

void printDeviations(const std::vector<PhantomView>& views)
{
    const Eigen::Matrix3d turn = commonTurn(views);
    core::ResultTable table;
    table.columns = {"view", "off the header, ° about camera x / y / z", "reported 1-σ °", "isocentre to centroid, mm",
                     "depth 1-σ mm"};
    for (const PhantomView& view : views) {
        const Eigen::Matrix3d expected = view.headerRotation * turn;
        const Eigen::Vector3d deviation = core::logSo3(view.result.cameraFromPatient.rotation * expected.transpose());
        const Eigen::Vector3d isocenter(0.0, 0.0, view.sourceToPatientMm);
        table.rows.push_back({{view.name, vectorText(deviation.unaryExpr(&inDegrees), 2),
                               vectorText(view.result.uncertainty.rotationDeg, 2),
                               vectorText(view.headerRotation.transpose() * (centroidInCamera(view) - isocenter), 1),
                               fixedText(view.result.uncertainty.depthMm, 1)},
                              false});
    }
    std::printf("Each view against the angles of its header, up to the one turn of the phantom\n\n%s\n",
                io::toPlainText(table).c_str());
}

/// Registers jointly with the header's angles almost fixed.
void printHeld(const std::vector<PhantomView>& views)
{
    const Eigen::Matrix3d turn = commonTurn(views);
    std::vector<core::RegistrationInput> inputs;
    for (const PhantomView& view : views) {
        core::RegistrationInput input = view.input;
        input.initialCameraFromPatient.rotation = view.headerRotation * turn;
        input.initialCameraFromPatient.translation =
            centroidInCamera(view) - input.initialCameraFromPatient.rotation * core::centroidInPatient(view.input.tree);
        inputs.push_back(std::move(input));
    }
    const auto held = core::registerViews(
        inputs, {}, {std::vector<core::RelativePoseStd>(inputs.size(), {0.02, {10.0, 10.0, 10.0}}), {}});
    if (!held) {
        std::printf("%s\n", held.error().message.text().c_str());
        return;
    }
    core::ResultTable table;
    table.columns = {"view", "median px alone", "with the header's angles", "p95 px alone", "with the header's angles"};
    for (std::size_t k = 0; k < views.size(); ++k) {
        const core::DistanceMetrics& alone = views[k].result.metrics;
        const core::DistanceMetrics& joint = held.value().views[k].metrics;
        table.rows.push_back({{views[k].name, fixedText(alone.medianPx, 2), fixedText(joint.medianPx, 2),
                               fixedText(alone.p95Px, 2), fixedText(joint.p95Px, 2)},
                              false});
    }
    std::printf("What the header's angles cost\n\n%s\n", io::toPlainText(table).c_str());
}

void printWithout(const std::vector<PhantomView>& views)
{
    core::ResultTable table;
    table.columns = {"without branch", "median px", "median difference", "largest"};
    for (const core::VesselBranch& branch : views.front().input.tree.branches) {
        std::vector<core::RegistrationInput> inputs;
        for (const PhantomView& view : views) {
            inputs.push_back(view.input);
            inputs.back().excludedBranchIds.push_back(branch.id);
        }
        double medianPx = 0.0;
        const auto rotations = rotationsOf(inputs, medianPx);
        if (rotations.empty()) {
            continue;
        }
        const auto pairs = pairsOf(rotations, headerRotations(views));
        table.rows.push_back(
            {{std::to_string(branch.id), fixedText(medianPx, 2), fixedText(medianDifferenceDeg(pairs), 2) + "°",
              fixedText(largestDifferenceDeg(pairs), 2) + "°"},
             false});
    }
    std::printf("What single branches do\n\n%s\n", io::toPlainText(table).c_str());
}

/// Prints the error of each branch in each view, first as registered, then at the pose from the other branches alone.
void printBranches(const std::vector<PhantomView>& views)
{
    core::ResultTable table;
    table.columns = {"branch", "points"};
    for (const PhantomView& view : views) {
        table.columns.push_back(view.name + " px, with / without it");
    }
    for (const core::VesselBranch& branch : views.front().input.tree.branches) {
        std::vector<std::string> cells{std::to_string(branch.id), std::to_string(branch.pointsInPatient.size())};
        for (const PhantomView& view : views) {
            core::RegistrationInput others = view.input;
            others.excludedBranchIds.push_back(branch.id);
            const auto without = core::registerVessels(others);
            const auto there = core::evaluatePose(view.input, without.value().cameraFromPatient);
            const auto medianPx = [&](const core::RegistrationResult& result) {
                const auto found = std::find_if(result.branches.begin(), result.branches.end(),
                                                [&](const auto& row) { return row.branchId == branch.id; });
                return found == result.branches.end() ? 0.0 : found->medianPx;
            };
            cells.push_back(fixedText(medianPx(view.result), 2) + " / " + fixedText(medianPx(there.value()), 2));
        }
        table.rows.push_back({std::move(cells), false});
    }
    std::printf("Median distance of each branch\n\n%s\n", io::toPlainText(table).c_str());
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const auto registered = registerPhantom(
        arguments.positional().empty() ? phantomFolder() : std::filesystem::path(arguments.positional().front()), {});
    if (!registered) {
        std::fprintf(stderr, "%s\n", registered.error().message.text().c_str());
        return 1;
    }
    const std::vector<PhantomView>& views = registered.value();
    printDeviations(views);
    printHeld(views);
    printBranches(views);
    printWithout(views);
    printFloor(views, static_cast<int>(arguments.number("trials", 100)),
               static_cast<std::uint64_t>(arguments.number("seed", 1)));
    return 0;
}
