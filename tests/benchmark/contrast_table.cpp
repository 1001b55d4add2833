// Prints whether contrast agent is detected in a single frame: annotated angiograms, unchanged and with their vessels
// painted over, with and without a catheter or guidewire; frames of the phantom; simulated frames.

#include "core/messages/messages.h"
#include "core/simulation/simulated_case.h"
#include "core/tracing/angiogram/curves/contrast_score.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "tests/benchmark/arguments.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/foreign_objects.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

using namespace angiopose;

namespace {

const char* const usage =
    "contrast_table [--images odd|even|all] [--each ]\n"
    "  --images <which>   odd judge (default), even ones chose the threshold\n"
    "  --each             a line for each frame\n";

core::ImageF picture(const std::string& name)
{
    auto read = io::readAngiogram(test::dataFile("coronary-angiograms-with-masks/training/" + name).string());
    return read ? read.value().frames.front() : core::ImageF{};
}

struct Counts {
    int frames = 0;
    int untraced = 0;   ///< nothing was found, and this is reported
    int reported = 0;   ///< traced, with the warning that there is little contrast agent
};

bool isKnown(const core::AngiogramTrace& trace)
{
    return std::ranges::any_of(trace.warnings, [](const core::Message& warning) {
        return warning.id() == core::messages::frameWithLittleContrast.id;
    });
}

void add(Counts& counts, const std::string& name, const core::Result<core::AngiogramTrace>& trace, bool isEachRequested)
{
    ++counts.frames;
    counts.untraced += trace ? 0 : 1;
    counts.reported += trace && isKnown(trace.value()) ? 1 : 0;
    if (isEachRequested && trace) {
        std::printf("%-26s %6.1f%s\n", name.c_str(),
                    core::contrastScore(trace.value().centerline, trace.value().suspectCurves, trace.value().vesselness,
                                        trace.value().clutter),
                    isKnown(trace.value()) ? "  flagged" : "");
    }
}

using core::Polarity;

struct Rows {
    bool isEachRequested;
    std::vector<std::pair<std::string, Counts>> rows = {};

    void trace(const std::string& group, const std::string& name, const core::ImageF& frame, Polarity polarity)
    {
        auto row = std::ranges::find(rows, group, &std::pair<std::string, Counts>::first);
        row = row == rows.end() ? rows.insert(row, {group, {}}) : row;
        add(row->second, group + " " + name, core::traceAngiogram(frame, polarity), isEachRequested);
    }
};

void traceAnnotated(Rows& rows, const std::string& which)
{
    for (int number = 1; number <= 40; ++number) {
        const core::ImageF frame = picture(std::to_string(number) + ".png");
        const core::ImageF truth = picture(std::to_string(number) + "_gt.png");
        const bool isWanted = which == "all" || (number % 2 == 1) == (which == "odd");
        if (!isWanted || frame.isEmpty() || truth.isEmpty()) {
            continue;
        }
        const std::string name = std::to_string(number);
        const auto seed = static_cast<std::uint64_t>(number);
        const core::ImageF empty = test::withoutVessels(frame, test::whitePixels(truth), 4, seed);
        rows.trace("angiograms", name, frame, Polarity::VesselsDark);
        rows.trace("vessels painted over", name, empty, Polarity::VesselsDark);
        for (const test::ForeignObject& object : test::foreignObjects()) {
            if (object.isDevice) {
                rows.trace("… and " + object.name, name, object.draw(empty, seed).frame, Polarity::VesselsDark);
            }
        }
    }
}

void tracePhantom(Rows& rows)
{
    for (const char* name : {"IM1.dcm", "IM2.dcm", "IM3.dcm", "IM4.dcm"}) {
        const auto run = io::readAngiogram(test::dataFile(std::string("coronary-phantom-xa/views-A/") + name).string());
        for (int frame = 0; run && frame < run.value().frameCount(); ++frame) {
            rows.trace(frame == 0 ? "phantom, first frame" : "phantom, from the 5th frame on",
                       std::string(name) + "/" + std::to_string(frame),
                       run.value().frames[static_cast<std::size_t>(frame)], run.value().polarity);
            frame += frame == 0 ? 3 : 0;
        }
    }
}

void traceSimulated(Rows& rows, int count)
{
    for (int k = 1; k <= count; ++k) {
        const core::SimulatedCase made = core::simulateCase(static_cast<std::uint64_t>(9000 + k));
        const core::Angiogram& run = made.angiogram;
        rows.trace("simulated, first frame", std::to_string(k), run.frames.front(), run.polarity);
        rows.trace("simulated, peak-opacification frame", std::to_string(k),
                   run.frames[static_cast<std::size_t>(run.suggestedFrame)], run.polarity);
    }
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    Rows rows{arguments.isSet("each")};
    traceAnnotated(rows, arguments.text("images", "odd"));
    tracePhantom(rows);
    traceSimulated(rows, 20);
    const auto dsa = io::readAngiogram(test::dataFile("cerebral-dsa-frame/Real-DSA-01.jpg").string());
    if (dsa) {
        rows.trace("cerebral DSA", "1", dsa.value().frames.front(), dsa.value().polarity);
    }
    std::printf("%-34s %8s %14s %8s\n", "", "frames", "nothing traced", "flagged");
    for (const auto& [group, counts] : rows.rows) {
        std::printf("%-34s %8d %14d %8d\n", group.c_str(), counts.frames, counts.untraced, counts.reported);
    }
    return 0;
}
