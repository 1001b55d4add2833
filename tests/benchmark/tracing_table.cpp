// Prints the quality and speed of angiogram tracing: centerline Dice of the 40 annotated angiograms and the time per
// frame, or the found and the falsely traced lengths in simulated runs.

#include "core/imaging/image_filters.h"
#include "core/support/format_number.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/test_data.h"
#include "tests/support/tracing_score.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <vector>

using namespace angiopose;

namespace {

using core::fixedText;

constexpr int imageCount = 40;

const char* const usage =
    "tracing_table [folder with N.png and N_gt.png]\n"
    "  --simulated <n>   instead, n simulated runs\n"
    "  --size <px>       sides of their frames (512)\n"
    "  --seed <n>        of the first of them (1)\n";

struct Row {
    test::CenterlineDice agreement;
    double maskDice = 0.0;
    double timeMs = 0.0;
};

/// Processor time of this program, to exclude other programs.
double processorMs()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

core::ImageF picture(const std::filesystem::path& path)
{
    auto read = io::readAngiogram(path.string());
    if (!read) {
        std::fprintf(stderr, "%s\n", read.error().message.text().c_str());
        return {};
    }
    return read.value().frames.front();
}

double maskDice(const core::Mask2d& mask, const core::Mask2d& truth)
{
    double both = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        both += mask.pixels[i] != 0 && truth.pixels[i] != 0 ? 2.0 : 0.0;
        sum += (mask.pixels[i] != 0 ? 1.0 : 0.0) + (truth.pixels[i] != 0 ? 1.0 : 0.0);
    }
    return sum > 0.0 ? both / sum : 0.0;
}

bool traceOne(const std::filesystem::path& folder, int number, Row& row)
{
    const core::ImageF frame = picture(folder / (std::to_string(number) + ".png"));
    const core::ImageF truth = picture(folder / (std::to_string(number) + "_gt.png"));
    if (frame.isEmpty() || truth.isEmpty()) {
        return false;
    }
    const double start = processorMs();
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    row.timeMs = processorMs() - start;
    if (trace) {
        row.agreement = test::centerlineDice(trace.value().centerline, test::whitePixels(truth));
        row.maskDice = maskDice(trace.value().vesselMask, test::whitePixels(truth));
    }
    return true;
}

void printTime(const core::ImageF& frame)
{
    std::vector<double> times;
    std::vector<double> wallTimes;
    for (int run = 0; run < 7; ++run) {
        const double start = processorMs();
        const auto begin = std::chrono::steady_clock::now();
        const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
        wallTimes.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        times.push_back(processorMs() - start);
    }
    std::sort(times.begin(), times.end());
    std::sort(wallTimes.begin(), wallTimes.end());
    std::printf("%4d x %-4d   wall %6.1f, fastest %6.1f ms   processor %6.1f, fastest %6.1f ms\n", frame.width,
                frame.height, wallTimes[wallTimes.size() / 2], wallTimes.front(), times[times.size() / 2],
                times.front());
}

std::string percent(double part, double whole)
{
    return whole > 0.0 ? fixedText(100.0 * part / whole, 1) : "-";
}

void addRow(core::ResultTable& table, const std::string& name, const test::TracingScore& score)
{
    table.rows.push_back(
        {{name, fixedText(score.visiblePx, 0), percent(score.foundPx, score.visiblePx), fixedText(score.tracedPx, 0),
          percent(score.falsePx, score.tracedPx), percent(score.falseUnsuspectedPx, score.tracedPx),
          percent(score.suspectVesselPx, score.tracedPx), fixedText(score.biasPx, 3), fixedText(score.curveBiasPx, 3),
          fixedText(score.radiusRatio, 3), fixedText(score.catheterPx, 0),
          percent(score.flaggedCatheterPx, score.catheterPx)},
         false});
}

void addTo(test::TracingScore& sum, const test::TracingScore& score, int count)
{
    sum.visiblePx += score.visiblePx;
    sum.foundPx += score.foundPx;
    sum.tracedPx += score.tracedPx;
    sum.falsePx += score.falsePx;
    sum.falseUnsuspectedPx += score.falseUnsuspectedPx;
    sum.suspectVesselPx += score.suspectVesselPx;
    sum.biasPx += score.biasPx / count;
    sum.curveBiasPx += score.curveBiasPx / count;
    sum.radiusRatio += score.radiusRatio / count;
    sum.catheterPx += score.catheterPx;
    sum.flaggedCatheterPx += score.flaggedCatheterPx;
}

int printSimulated(int count, int size, int firstSeed)
{
    core::ResultTable table;
    table.columns = {"seed",        "visible px",    "found %",          "traced px",
                     "false %",     "not suspect %", "vessel suspect %", "bias px",
                     "sideways px", "radius x",      "catheter px",      "flagged %"};
    test::TracingScore sum;
    core::DsaOptions dsa;
    dsa.width = size;
    dsa.height = size;
    for (int seed = firstSeed; seed < firstSeed + count; ++seed) {
        const core::SimulatedCase simulated = core::simulateCase(static_cast<std::uint64_t>(seed), {}, dsa);
        const auto trace = core::traceAngiogram(
            simulated.angiogram.frames[static_cast<std::size_t>(simulated.angiogram.suggestedFrame)],
            simulated.angiogram.polarity);
        const test::TracingScore score = test::scoreTracing(simulated, trace ? trace.value() : core::AngiogramTrace{});
        addRow(table, std::to_string(seed), score);
        addTo(sum, score, count);
    }
    addRow(table, "all", sum);
    std::printf(
        "%d simulated runs of %d x %d px, peak-opacification frame, one set of defaults\n"
        "visible: wider than 2 px, outside other vessels, own contrast at least 2 x noise; found within 2 px;\n"
        "false: beside every filled vessel and the catheter; bias, sideways and radius: mean over the runs\n\n%s",
        count, size, size, io::toPlainText(table).c_str());
    return 0;
}

int printAnnotated(const std::filesystem::path& folder)
{
    std::vector<double> dices;
    double maskDices = 0.0;
    std::printf("image   clDice   curve in mask   mask's skeleton found   mask Dice    ms\n");
    for (int number = 1; number <= imageCount; ++number) {
        Row row;
        if (!traceOne(folder, number, row)) {
            return 1;
        }
        dices.push_back(row.agreement.dice());
        std::printf("%5d   %6.3f   %13.3f   %21.3f   %9.3f   %3.0f\n", number, dices.back(), row.agreement.precision,
                    row.agreement.sensitivity, row.maskDice, row.timeMs);
        maskDices += row.maskDice / imageCount;
    }
    const double mean = std::accumulate(dices.begin(), dices.end(), 0.0) / imageCount;
    std::printf(" mean   %6.3f   %49.3f\n  min   %6.3f\n\nMedian time of seven traces, on two threads:\n", mean,
                maskDices, *std::min_element(dices.begin(), dices.end()));
    const core::ImageF frame = test::drawnFrame(
        512, 512, {test::line({60, 80}, {430, 400}), test::line({80, 400}, {400, 90}), test::circle({250, 250}, 150)},
        4.0, {.noise = 6.0});
    printTime(frame);
    printTime(core::upsample(frame, 2, 1024, 1024));
    return 0;
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    if (arguments.isSet("simulated")) {
        return printSimulated(static_cast<int>(arguments.number("simulated", 40)),
                              static_cast<int>(arguments.number("size", 512)),
                              static_cast<int>(arguments.number("seed", 1)));
    }
    return printAnnotated(arguments.positional().empty() ? test::dataFile("coronary-angiograms-with-masks/training")
                                                         : std::filesystem::path(arguments.positional().front()));
}
