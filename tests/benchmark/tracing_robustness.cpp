// Prints how tracing fares on modified images of the same vessels: the annotated angiograms and the thoracic CTA,
// changed as by other devices, exports and viewers, with one set of defaults.

#include "core/support/format_number.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "core/tracing/volume/trace_vessels.h"
#include "io/angiogram_file.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/thoracic_course.h"
#include "tests/benchmark/thoracic_scan.h"
#include "tests/support/altered_frame.h"
#include "tests/support/altered_scan.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>

using namespace angiopose;

namespace {

using core::fixedText;

const char* const usage =
    "tracing_robustness [--frames ] [--scan ] [--only <text>] [--images <n>] [--seeds <n>]\n"
    "  Without --frames or --scan both are printed.\n"
    "  --only <text>   changes whose name contains it\n"
    "  --images <n>    of the 40 angiograms (40)\n"
    "  --seeds <n>     places in the aorta (8)\n";

constexpr int imageCount = 40;

std::optional<core::ImageF> picture(const std::string& name)
{
    auto read = io::readAngiogram(test::dataFile("coronary-angiograms-with-masks/training/" + name).string());
    if (!read) {
        std::fprintf(stderr, "%s\n", read.error().message.text().c_str());
        return std::nullopt;
    }
    return read.value().frames.front();
}

std::vector<test::DrawnFrame> annotatedFrames(int count)
{
    std::vector<test::DrawnFrame> frames;
    for (int number = 1; number <= count; ++number) {
        auto frame = picture(std::to_string(number) + ".png");
        auto truth = picture(std::to_string(number) + "_gt.png");
        if (frame && truth) {
            frames.push_back({std::move(*frame), std::move(*truth)});
        }
    }
    return frames;
}

/// Agreement with the annotated vessels for every frame.
struct FrameScores {
    std::vector<double> dices;
    double precision = 0.0;
    double sensitivity = 0.0;

    double mean() const { return std::accumulate(dices.begin(), dices.end(), 0.0) / static_cast<double>(dices.size()); }
    std::size_t worst() const
    {
        return static_cast<std::size_t>(std::min_element(dices.begin(), dices.end()) - dices.begin());
    }
};

FrameScores scoresOf(const std::vector<test::DrawnFrame>& frames, const test::FrameChange& change)
{
    FrameScores scores;
    for (const test::DrawnFrame& original : frames) {
        const test::DrawnFrame drawn = change.apply(original);
        const auto trace = core::traceAngiogram(drawn.frame, drawn.polarity);
        const test::CenterlineDice dice =
            trace ? test::centerlineDice(trace.value().centerline, test::whitePixels(drawn.truth))
                  : test::CenterlineDice{};
        scores.dices.push_back(dice.dice());
        scores.precision += dice.precision / static_cast<double>(frames.size());
        scores.sensitivity += dice.sensitivity / static_cast<double>(frames.size());
    }
    return scores;
}

void printFrames(int count, const std::string& only)
{
    const std::vector<test::DrawnFrame> frames = annotatedFrames(count);
    if (frames.empty()) {
        return;
    }
    core::ResultTable table;
    table.columns = {"angiograms", "mean clDice", "lowest", "of image", "largest loss", "curve in mask", "mask found"};
    std::vector<double> unchanged;
    for (const test::FrameChange& change : test::frameChanges()) {
        if (!unchanged.empty() && change.name.find(only) == std::string::npos) {
            continue;
        }
        const FrameScores scores = scoresOf(frames, change);
        unchanged = unchanged.empty() ? scores.dices : unchanged;
        double loss = 0.0;
        for (std::size_t i = 0; i < frames.size(); ++i) {
            loss = std::max(loss, unchanged[i] - scores.dices[i]);
        }
        table.rows.push_back({{change.name, fixedText(scores.mean(), 3), fixedText(scores.dices[scores.worst()], 3),
                               std::to_string(scores.worst() + 1), fixedText(loss, 3), fixedText(scores.precision, 3),
                               fixedText(scores.sensitivity, 3)},
                              false});
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
}

core::ResultTable scanTable()
{
    core::ResultTable table;
    table.columns = {"thoracic CTA",     "inside masks",  "as bright", "other",
                     "inside of judged", "masks covered", "branches",  "length mm"};
    return table;
}

void addRow(core::ResultTable& table, const std::string& name, const benchmarks::ThoracicScan& thorax,
            const core::Volume& scan, const core::VesselTracingOptions& options)
{
    const auto traced = core::traceVessels(scan, options);
    if (!traced) {
        table.rows.push_back({{name + ": " + traced.error().message.text(), "", "", "", "", "", "", ""}, false});
        return;
    }
    const core::VesselTree& tree = traced.value().tree;
    const benchmarks::Course course = benchmarks::courseOf(tree, thorax, &scan.geometry);
    table.rows.push_back(
        {{name, fixedText(course.inside, 3), fixedText(course.outsideArterial, 3), fixedText(course.outsideOther, 3),
          fixedText(course.insideOfJudged, 3), fixedText(course.covered, 3), std::to_string(tree.branches.size()),
          fixedText(course.lengthMm, 0)},
         false});
}

void printScan(int seeds, const std::string& only)
{
    const auto thorax = benchmarks::readThoracicScan();
    if (!thorax) {
        return;
    }
    core::VesselTracingOptions options;
    options.seedsInPatient = {benchmarks::seedOf(*thorax)};
    core::ResultTable table = scanTable();
    core::ResultTable unseeded = scanTable();
    for (const test::ScanChange& change : test::scanChanges()) {
        if (change.name.find(only) != std::string::npos) {
            const core::Volume changed = change.apply(thorax->scan);
            addRow(table, change.name, *thorax, changed, options);
            addRow(unseeded, change.name + ", no seed", *thorax, changed, {});
        }
    }
    if (only.empty()) {
        for (const Eigen::Vector3d& place : benchmarks::placesInAorta(*thorax, seeds)) {
            options.seedsInPatient = {place};
            const Eigen::Vector3d voxel = thorax->scan.geometry.patientFromVoxel().inverse() * place;
            addRow(table,
                   "seed " + fixedText(voxel.x(), 0) + " " + fixedText(voxel.y(), 0) + " " + fixedText(voxel.z(), 0),
                   *thorax, thorax->scan, options);
        }
    }
    std::printf("%s\n%s\n", io::toPlainText(table).c_str(), io::toPlainText(unseeded).c_str());
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const bool isAll = !arguments.isSet("frames") && !arguments.isSet("scan");
    const std::string only = arguments.text("only", "");
    if (isAll || arguments.isSet("frames")) {
        printFrames(static_cast<int>(arguments.number("images", imageCount)), only);
    }
    if (isAll || arguments.isSet("scan")) {
        printScan(static_cast<int>(arguments.number("seeds", 8)), only);
    }
    return 0;
}
