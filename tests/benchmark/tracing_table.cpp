// Prints how well and how fast angiograms are traced: centreline Dice of the 40 annotated angiograms, and the time a
// frame takes. Usage: tracing_table [folder with N.png and N_gt.png]

#include "core/imaging/image_filters.h"
#include "core/tracing/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/drawn_vessels.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <numeric>
#include <vector>

namespace {

constexpr int imageCount = 40;

struct Row {
    test::CenterlineDice agreement;
    double timeMs = 0.0;
};

/// Processor time of this program, so that other programs do not count.
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
        std::fprintf(stderr, "%s\n", read.error().message.c_str());
        return {};
    }
    return read.value().frames.front();
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
    }
    return true;
}

void printTime(const core::ImageF& frame)
{
    std::vector<double> times;
    for (int run = 0; run < 7; ++run) {
        const double start = processorMs();
        const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
        times.push_back(processorMs() - start);
    }
    std::sort(times.begin(), times.end());
    std::printf("%4d x %-4d   fastest %6.1f ms   median %6.1f ms\n", frame.width, frame.height, times.front(),
                times[times.size() / 2]);
}

}   // namespace

int main(int count, char** arguments)
{
    const std::filesystem::path folder =
        count > 1 ? arguments[1] : test::dataFile("coronary-angiograms-with-masks/training");
    std::vector<double> dices;
    std::printf("image   clDice   curve in mask   mask's skeleton found    ms\n");
    for (int number = 1; number <= imageCount; ++number) {
        Row row;
        if (!traceOne(folder, number, row)) {
            return 1;
        }
        dices.push_back(row.agreement.dice());
        std::printf("%5d   %6.3f   %13.3f   %21.3f   %3.0f\n", number, dices.back(), row.agreement.precision,
                    row.agreement.sensitivity, row.timeMs);
    }
    const double mean = std::accumulate(dices.begin(), dices.end(), 0.0) / imageCount;
    std::printf(" mean   %6.3f\n  min   %6.3f\n\nProcessor time, one thread:\n", mean,
                *std::min_element(dices.begin(), dices.end()));
    const core::ImageF frame = test::drawnFrame(
        512, 512, {test::line({60, 80}, {430, 400}), test::line({80, 400}, {400, 90}), test::circle({250, 250}, 150)},
        4.0, {.noise = 6.0});
    printTime(frame);
    printTime(core::enlarged(frame, 2, 1024, 1024));
    return 0;
}
