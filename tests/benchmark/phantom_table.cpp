// Registers the four real views of the coronary phantom with default options and automatic tracing. The views show one
// rigid body, so the rotation between two registered views must agree with the angles in the DICOM headers.

#include "core/registration/options/option_text.h"
#include "core/registration/register_views.h"
#include "core/support/format_number.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"
#include "tests/benchmark/phantom_views.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace angiopose;

namespace {

using namespace benchmarks;
using core::fixedText;

constexpr double aimedMedianPx = 1.0;
constexpr double aimedLargestDeg = 1.2;
constexpr double aimedMedianDeg = 0.7;

const char* const usage =
    "phantom_table [folder with IM1.angiopose … IM4.angiopose]\n"
    "  --method <id>     another method (angiopose)\n"
    "  --set <list>      options by their key in files, comma-separated (finalScalePx=0.5)\n";

std::string angleText(double deg, const char* positive, const char* negative)
{
    return std::string(deg < 0.0 ? negative : positive) + " " + fixedText(std::abs(deg), 1) + "°";
}

void printViews(const std::vector<PhantomView>& views)
{
    core::ResultTable table;
    table.columns = {"view",     "primary",  "secondary", "median px",   "p75",  "p95",
                     "coverage", "depth mm", "trace ms",  "register ms", "stop", "trustworthy"};
    for (const PhantomView& view : views) {
        const core::DistanceMetrics& m = view.result.metrics;
        table.rows.push_back(
            {{view.name, angleText(view.primaryDeg, "LAO", "RAO"), angleText(view.secondaryDeg, "CRA", "CAU"),
              fixedText(m.medianPx, 2), fixedText(m.p75Px, 2), fixedText(m.p95Px, 2),
              fixedText(100.0 * m.coverage, 0) + " %", fixedText(view.depthMm, 1), fixedText(view.traceMs, 0),
              fixedText(view.result.time.totalMs, 0), std::string(core::toText(view.result.stopReason)),
              view.result.trustworthy ? "yes" : "no"},
             false});
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
}

/// 1-σ angle of the relative rotation that the covariances of the two views allow.
double reportedDeg(const PhantomView& a, const PhantomView& b)
{
    const auto turns = [](const PhantomView& view) {
        return view.result.uncertainty.covariance.topLeftCorner<3, 3>().trace();
    };
    return inDegrees(std::sqrt(turns(a) + turns(b)));
}

/// Ratio of the rms difference to the reported one. `headerDeg`: 1-σ error angle of the rotation between two views
/// according to the header.
double rmsOverReported(const std::vector<PhantomView>& views, const std::vector<PhantomPair>& pairs, double headerDeg)
{
    double squares = 0.0;
    for (const PhantomPair& pair : pairs) {
        const double ratio =
            pair.differenceDeg / std::hypot(reportedDeg(views[pair.first], views[pair.second]), headerDeg);
        squares += ratio * ratio / static_cast<double>(pairs.size());
    }
    return std::sqrt(squares);
}

void printPairs(const std::vector<PhantomView>& views, const std::vector<PhantomPair>& pairs)
{
    core::ResultTable table;
    table.columns = {"pair", "registered", "by DICOM angles", "difference", "reported σ"};
    for (const PhantomPair& pair : pairs) {
        table.rows.push_back(
            {{views[pair.first].name + "–" + views[pair.second].name, fixedText(pair.registeredDeg, 2) + "°",
              fixedText(pair.expectedDeg, 2) + "°", fixedText(pair.differenceDeg, 2) + "°",
              fixedText(reportedDeg(views[pair.first], views[pair.second]), 2) + "°"},
             false});
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
}

bool printAim(const char* what, double value, double limit, const char* unit)
{
    const bool isMet = value <= limit;
    std::printf("%-44s %5.2f %-3s (aim: at most %.1f %s)  %s\n", what, value, unit, limit, unit,
                isMet ? "reached" : "MISSED");
    return isMet;
}

}   // namespace

int main(int argc, char** argv)
{
    const Arguments arguments(argc, argv, usage);
    const std::filesystem::path folder =
        arguments.positional().empty() ? phantomFolder() : std::filesystem::path(arguments.positional().front());
    core::RegistrationOptions options;
    options.method = arguments.text("method", options.method);
    for (const std::string& assignment : arguments.list("set", "")) {
        if (const auto status = core::setOption(options, assignment); !status) {
            std::fprintf(stderr, "%s\n", status.error().message.text().c_str());
            return 2;
        }
    }
    const auto registered = registerPhantom(folder, options);
    if (!registered) {
        std::fprintf(stderr, "%s\n", registered.error().message.text().c_str());
        return 1;
    }
    const std::vector<PhantomView>& views = registered.value();
    std::printf("Coronary phantom, real XA: default options, automatic tracing, rough start poses\n\n");
    printViews(views);
    std::printf("Rotation between two views\n\n");
    const std::vector<PhantomPair> pairs = pairsOf(registeredRotations(views), headerRotations(views));
    printPairs(views, pairs);
    double worstPx = 0.0;
    for (const PhantomView& view : views) {
        worstPx = std::max(worstPx, view.result.metrics.medianPx);
    }
    const bool isNear = printAim("Largest median projection distance", worstPx, aimedMedianPx, "px");
    const bool isConsistent =
        printAim("Largest difference of relative rotations", largestDifferenceDeg(pairs), aimedLargestDeg, "°");
    const bool isTypical =
        printAim("Median difference of relative rotations", medianDifferenceDeg(pairs), aimedMedianDeg, "°");
    const double headerDeg = std::sqrt(3.0) * core::RelativePoseStd().rotationDeg;
    std::printf("%-44s %5.2f     (aim: 0.7 to 1.3)\n", "Differences over reported σ, rms",
                rmsOverReported(views, pairs, 0.0));
    std::printf("%-44s %5.2f\n", "… with what joint registration allows headers",
                rmsOverReported(views, pairs, headerDeg));
    return isNear && isConsistent && isTypical ? 0 : 1;
}
