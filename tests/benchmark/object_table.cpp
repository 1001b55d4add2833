// Prints how much of objects that are not vessels (borders, shutters, letters, guidewires, catheters) is traced when
// they are drawn into the annotated angiograms, and whether devices are flagged.

#include "core/support/format_number.h"
#include "core/tracing/angiogram/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/support/centerline_dice.h"
#include "tests/support/foreign_objects.h"
#include "tests/support/test_data.h"

#include <algorithm>
#include <cstdio>
#include <utility>

using namespace angiopose;

namespace {

using core::fixedText;

const char* const usage =
    "object_table [--images odd|even|all] [--only <text>] [--each ]\n"
    "  --images <which>   odd judge (default), even are for choosing\n"
    "  --only <text>      objects whose name contains it\n"
    "  --each             a line for each frame\n";

constexpr int imageCount = 40;
constexpr double besideVesselPx = 4.0;

struct Score {
    double drawnPx = 0.0;
    double tracedPx = 0.0;   ///< traced length on the object, away from annotated vessels
    double unflaggedPx = 0.0;   ///< part of it that is not flagged
    double beforePx = 0.0;   ///< traced there in the frame without the object: vessels that are not annotated
    double clDice = 0.0;
    int frames = 0;
    int untouched = 0;   ///< frames in which no part of the object was traced
};

bool isNearMask(const core::Mask2d& mask, const Eigen::Vector2d& point, double reachPx)
{
    const int reach = static_cast<int>(reachPx);
    const int x0 = static_cast<int>(point.x());
    const int y0 = static_cast<int>(point.y());
    for (int y = y0 - reach; y <= y0 + reach; ++y) {
        for (int x = x0 - reach; x <= x0 + reach; ++x) {
            if (mask.contains(x, y) && mask.at(x, y) != 0) {
                return true;
            }
        }
    }
    return false;
}

bool isOnObject(const test::ObjectFrame& object, const Eigen::Vector2d& point)
{
    return std::ranges::any_of(
        object.courses, [&](const test::Path& course) { return test::distanceTo(course, point) <= object.reachPx; });
}

double lengthInside(const test::ObjectFrame& object, const core::Mask2d& truth)
{
    double length = 0.0;
    for (const test::Path& course : object.courses) {
        for (std::size_t i = 1; i < course.size(); ++i) {
            const Eigen::Vector2d middle = 0.5 * (course[i] + course[i - 1]);
            const bool isSeen = truth.contains(static_cast<int>(middle.x()), static_cast<int>(middle.y())) &&
                                !isNearMask(truth, middle, besideVesselPx);
            length += isSeen ? (course[i] - course[i - 1]).norm() : 0.0;
        }
    }
    return length;
}

bool isFlagged(const core::AngiogramTrace& trace, const core::Curve2d& curve)
{
    return std::ranges::find(trace.suspectCurves, curve.id) != trace.suspectCurves.end();
}

/// Traced px on the object: in all, and on curves that are not flagged.
std::pair<double, double> tracedOn(const test::ObjectFrame& object, const core::Mask2d& truth,
                                   const core::AngiogramTrace& trace)
{
    double all = 0.0;
    double unflagged = 0.0;
    for (const core::Curve2d& curve : core::resampled(trace.centerline, 1.0).curves) {
        for (const Eigen::Vector2d& point : curve.pointsPx) {
            if (isOnObject(object, point) && !isNearMask(truth, point, besideVesselPx)) {
                all += 1.0;
                unflagged += isFlagged(trace, curve) ? 0.0 : 1.0;
            }
        }
    }
    return {all, unflagged};
}

void addTrace(const test::ObjectFrame& object, const core::ImageF& without, const core::Mask2d& truth, Score& score)
{
    score.drawnPx += lengthInside(object, truth);
    ++score.frames;
    if (const auto before = core::traceAngiogram(without, core::Polarity::VesselsDark)) {
        score.beforePx += tracedOn(object, truth, before.value()).first;
    }
    const auto trace = core::traceAngiogram(object.frame, core::Polarity::VesselsDark);
    if (!trace) {
        ++score.untouched;
        return;
    }
    score.clDice += test::centerlineDice(trace.value().centerline, truth).dice();
    const auto [all, unflagged] = tracedOn(object, truth, trace.value());
    score.tracedPx += all;
    score.unflaggedPx += unflagged;
    score.untouched += all < 1.0 ? 1 : 0;
}

void addRow(core::ResultTable& table, const std::string& name, const Score& score)
{
    const auto share = [&](double px) { return fixedText(100.0 * px / std::max(1.0, score.drawnPx), 1); };
    table.rows.push_back({{name, std::to_string(score.frames), fixedText(score.drawnPx, 0), share(score.tracedPx),
                           share(score.unflaggedPx), share(score.beforePx), std::to_string(score.untouched),
                           fixedText(score.clDice / std::max(1, score.frames), 3)},
                          false});
}

/// Share of the traced px on annotated vessels that is wrongly flagged, over unmodified frames.
struct FlaggedVessels {
    double vesselPx = 0.0;
    double flaggedPx = 0.0;

    void add(const core::ImageF& frame, const core::Mask2d& truth)
    {
        const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
        if (!trace) {
            return;
        }
        for (const core::Curve2d& curve : core::resampled(trace.value().centerline, 1.0).curves) {
            for (const Eigen::Vector2d& point : curve.pointsPx) {
                const double isVessel = isNearMask(truth, point, 1.0) ? 1.0 : 0.0;
                vesselPx += isVessel;
                flaggedPx += isFlagged(trace.value(), curve) ? isVessel : 0.0;
            }
        }
    }
};

/// Traced px of a frame: in all, and on curves that are not flagged.
std::pair<double, double> tracedIn(const core::ImageF& frame)
{
    const auto trace = core::traceAngiogram(frame, core::Polarity::VesselsDark);
    double all = 0.0;
    double unflagged = 0.0;
    if (trace) {
        for (const core::Curve2d& curve : trace.value().centerline.curves) {
            all += curve.lengthPx();
            unflagged += isFlagged(trace.value(), curve) ? 0.0 : curve.lengthPx();
        }
    }
    return {all, unflagged};
}

core::ImageF picture(const std::string& name)
{
    auto read = io::readAngiogram(test::dataFile("coronary-angiograms-with-masks/training/" + name).string());
    return read ? read.value().frames.front() : core::ImageF{};
}

bool isChosen(int number, const std::string& which)
{
    return which == "all" || (number % 2 == 1) == (which == "odd");
}

void printWithoutVessels(const std::string& which, bool isEachRequested)
{
    int frames = 0;
    int refused = 0;
    double before = 0.0;
    double after = 0.0;
    double unflagged = 0.0;
    FlaggedVessels flagged;
    for (int number = 1; number <= imageCount; ++number) {
        const core::ImageF frame = picture(std::to_string(number) + ".png");
        const core::ImageF truth = picture(std::to_string(number) + "_gt.png");
        if (!isChosen(number, which) || frame.isEmpty() || truth.isEmpty()) {
            continue;
        }
        flagged.add(frame, test::whitePixels(truth));
        const auto whole = tracedIn(frame);
        const auto rest =
            tracedIn(test::withoutVessels(frame, test::whitePixels(truth), 4, static_cast<std::uint64_t>(number)));
        if (isEachRequested) {
            std::printf("%4d  traced %6.0f px, without vessels %6.0f, not flagged %6.0f\n", number, whole.first,
                        rest.first, rest.second);
        }
        ++frames;
        refused += rest.first > 0.0 ? 0 : 1;
        before += whole.first;
        after += rest.first;
        unflagged += rest.second;
    }
    std::printf("%.1f %% of %.0f px traced along annotated vessels are flagged as devices\n",
                100.0 * flagged.flaggedPx / std::max(1.0, flagged.vesselPx), flagged.vesselPx);
    std::printf(
        "%d frames, vessels painted over: in %d nothing is traced; of what was traced before %.1f %% is, %.1f %% "
        "not flagged\n\n",
        frames, refused, 100.0 * after / std::max(1.0, before), 100.0 * unflagged / std::max(1.0, before));
}

}   // namespace

int main(int count, char** values)
{
    const benchmarks::Arguments arguments(count, values, usage);
    const std::string which = arguments.text("images", "odd");
    core::ResultTable table;
    table.columns = {"drawn", "frames", "drawn px", "traced %", "not flagged %", "without it %", "untouched", "clDice"};
    for (const test::ForeignObject& object : test::foreignObjects()) {
        if (object.name.find(arguments.text("only", "")) == std::string::npos) {
            continue;
        }
        Score score;
        for (int number = 1; number <= imageCount; ++number) {
            if (!isChosen(number, which)) {
                continue;
            }
            const core::ImageF frame = picture(std::to_string(number) + ".png");
            const core::ImageF truth = picture(std::to_string(number) + "_gt.png");
            if (frame.isEmpty() || truth.isEmpty()) {
                std::fprintf(stderr, "The annotated angiograms are not at hand.\n");
                return 1;
            }
            const Score before = score;
            addTrace(object.draw(frame, static_cast<std::uint64_t>(number)), frame, test::whitePixels(truth), score);
            if (arguments.isSet("each")) {
                std::printf("%4d  %-18s traced %5.0f px, not flagged %5.0f, without it %5.0f\n", number,
                            object.name.c_str(), score.tracedPx - before.tracedPx,
                            score.unflaggedPx - before.unflaggedPx, score.beforePx - before.beforePx);
            }
        }
        addRow(table, object.name, score);
    }
    printWithoutVessels(which, arguments.isSet("each"));
    std::printf(
        "Drawn into the annotated angiograms (%s numbers), one set of defaults. Traced: within the object's reach,\n"
        "farther than %.0f px from annotated vessels; without it: the same place in the frame as it is.\n\n%s",
        which.c_str(), besideVesselPx, io::toPlainText(table).c_str());
    return 0;
}
