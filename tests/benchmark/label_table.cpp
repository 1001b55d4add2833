// Prints how completely vessel masks and labels are traced: the share of a label's own skeleton (thinned component by
// component) within two voxels of the curves, the number of components found, and the messages about the others.

#include "core/evaluation/report/result_table.h"
#include "core/support/format_number.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/evaluation/table_text.h"
#include "io/volume_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/label_cover.h"
#include "tests/benchmark/label_masks.h"
#include "tests/benchmark/timing.h"

#include <algorithm>
#include <cstdio>
#include <optional>

using namespace angiopose;

namespace {

using core::fixedText;

const std::string usage =
    "Usage: label_table [--given ] [--patients ] [--grown <n>] [--file <label image>] [--words ]\n"
    "  --given: masks, labels and surfaces of the test data; --patients: trees of patients drawn as tubes;\n"
    "  --grown <n>: n trees of the simulator, drawn as tubes, alone, in twos, in pieces, cropped (4);\n"
    "  --file: any label image; --words: what was said of each. Without a choice the first three are printed.\n";

void addRow(core::ResultTable& table, const benchmarks::NamedMask& label, bool withWords)
{
    std::optional<core::Result<core::TracedVessels>> traced;
    const benchmarks::Timing time = benchmarks::timed([&] { traced = core::traceMask(label.mask); });
    if (!*traced) {
        table.rows.push_back(
            {{label.name + ": " + traced->error().message.text(), "", "", "", "", "", "", "", "", ""}, false});
        return;
    }
    const core::TracedVessels& vessels = traced->value();
    const benchmarks::LabelCover cover = benchmarks::coverOf(label.mask, vessels.tree);
    const auto roots = std::ranges::count(vessels.tree.branches, 0, &core::VesselBranch::generation);
    table.rows.push_back({{label.name, fixedText(cover.ofSkeleton, 3), fixedText(cover.ofVessels, 3),
                           std::to_string(cover.pieces), std::to_string(cover.traced), fixedText(cover.leftOut, 4),
                           std::to_string(roots), std::to_string(vessels.tree.branches.size()),
                           std::to_string(cover.ends) + "/" + std::to_string(cover.cuts), fixedText(time.wall, 1)},
                          false});
    for (const core::Message& warning : vessels.warnings) {
        if (withWords) {
            std::printf("%s: %s\n", label.name.c_str(), warning.text().c_str());
        }
    }
}

void printTable(const std::string& title, const std::vector<benchmarks::NamedMask>& labels, bool withWords)
{
    core::ResultTable table;
    table.title = title;
    table.columns = {"label",    "skeleton", "vessels",  "pieces",        "traced",
                     "left out", "roots",    "branches", "ends/cuts rim", "wall [s]"};
    for (const benchmarks::NamedMask& label : labels) {
        addRow(table, label, withWords);
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
}

std::vector<benchmarks::NamedMask> maskIn(const std::string& file)
{
    const auto labels = io::readLabels(file);
    if (!labels) {
        std::printf("%s\n", labels.error().message.text().c_str());
        return {};
    }
    core::VoxelMask mask(labels.value().geometry);
    std::ranges::transform(labels.value().voxels, mask.voxels.begin(),
                           [](std::uint16_t label) { return static_cast<std::uint8_t>(label != 0 ? 1 : 0); });
    return {{file.substr(file.find_last_of('/') + 1), std::move(mask)}};
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const bool isAll = !arguments.isSet("given") && !arguments.isSet("patients") && !arguments.isSet("grown") &&
                       !arguments.isSet("file");
    const bool withWords = arguments.isSet("words");
    if (isAll || arguments.isSet("given")) {
        printTable("Masks, labels and surfaces", benchmarks::givenMasks(), withWords);
    }
    if (isAll || arguments.isSet("patients")) {
        printTable("Trees of patients, drawn as tubes", benchmarks::masksOfPatients(), withWords);
    }
    if (isAll || arguments.isSet("grown")) {
        printTable("Grown trees, drawn as tubes",
                   benchmarks::grownMasks(static_cast<int>(arguments.number("grown", 4))), withWords);
    }
    if (arguments.isSet("file")) {
        printTable("Label image", maskIn(arguments.text("file", "")), withWords);
    }
    return 0;
}
