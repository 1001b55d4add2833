// Registers the four real views of the coronary phantom with default options and automatic tracing. The views show one
// rigid body, so the rotation between two registered views must agree with the angles in the DICOM headers.

#include "core/registration/option_text.h"
#include "core/registration_case.h"
#include "core/support/format_number.h"
#include "io/case_file.h"
#include "io/evaluation/table_text.h"
#include "tests/benchmark/arguments.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>

namespace {

using namespace benchmarks;
using core::fixedText;

constexpr double largestMedianPx = 1.0;
constexpr double largestDifferenceDeg = 1.2;
constexpr double medianDifferenceDeg = 0.7;

const char* const usage =
    "phantom_table [folder with IM1.angiopose … IM4.angiopose]\n"
    "  --method <id>     another method (angiopose)\n"
    "  --set <list>      options by their key in files, comma-separated (finalScalePx=0.5)\n";

struct View {
    std::string name;
    double primaryDeg = 0.0;
    double secondaryDeg = 0.0;
    Eigen::Matrix3d headerRotation = Eigen::Matrix3d::Identity();   ///< cameraFromPatient by the header's angles
    core::RegistrationResult result;
    double depthMm = 0.0;   ///< of the tree's centroid
    double traceMs = 0.0;
};

double milliseconds(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double degrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

core::Result<View> registerView(const std::filesystem::path& path, const core::RegistrationOptions& options)
{
    std::vector<std::string> warnings;
    auto loaded = io::loadCase(path.string(), warnings);
    if (!loaded) {
        return loaded.error();
    }
    core::RegistrationCase registrationCase = std::move(loaded).value();
    registrationCase.options = options;
    const auto headerPose = core::cameraFromPatient(registrationCase.cArm, Eigen::Vector3d::Zero());
    if (!headerPose) {
        return headerPose.error();
    }
    const auto begin = std::chrono::steady_clock::now();
    auto target = core::targetOf(registrationCase);
    if (!target) {
        return target.error();
    }
    View view;
    view.traceMs = milliseconds(begin);
    const auto input = core::registrationInputOf(registrationCase, std::move(target).value());
    if (!input) {
        return input.error();
    }
    auto result = core::registerVessels(input.value(), registrationCase.options);
    if (!result) {
        return result.error();
    }
    view.name = path.stem().string();
    view.primaryDeg = registrationCase.cArm.primaryAngleDeg.value.value_or(0.0);
    view.secondaryDeg = registrationCase.cArm.secondaryAngleDeg.value.value_or(0.0);
    view.headerRotation = headerPose.value().rotation;
    view.result = std::move(result).value();
    view.depthMm = (view.result.cameraFromPatient * core::centroidInPatient(*registrationCase.tree)).z();
    return view;
}

std::string angleText(double deg, const char* positive, const char* negative)
{
    return std::string(deg < 0.0 ? negative : positive) + " " + fixedText(std::abs(deg), 1) + "°";
}

void printViews(const std::vector<View>& views)
{
    core::ResultTable table;
    table.columns = {"view",     "primary",  "secondary", "median px",   "p75",  "p95",
                     "coverage", "depth mm", "trace ms",  "register ms", "stop", "trustworthy"};
    for (const View& view : views) {
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

/// Prints the pairs and returns the angles between registered and expected relative rotation.
std::vector<double> printPairs(const std::vector<View>& views)
{
    core::ResultTable table;
    table.columns = {"pair", "registered", "by DICOM angles", "difference"};
    std::vector<double> differencesDeg;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            const Eigen::Matrix3d registered =
                views[b].result.cameraFromPatient.rotation * views[a].result.cameraFromPatient.rotation.transpose();
            const Eigen::Matrix3d expected = views[b].headerRotation * views[a].headerRotation.transpose();
            differencesDeg.push_back(degrees(core::angleBetween(registered, expected)));
            const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
            table.rows.push_back({{views[a].name + "–" + views[b].name,
                                   fixedText(degrees(core::angleBetween(registered, none)), 2) + "°",
                                   fixedText(degrees(core::angleBetween(expected, none)), 2) + "°",
                                   fixedText(differencesDeg.back(), 2) + "°"},
                                  false});
        }
    }
    std::printf("%s\n", io::toPlainText(table).c_str());
    return differencesDeg;
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
    const std::filesystem::path folder = arguments.positional().empty()
                                             ? std::filesystem::path(TEST_DATA_DIR) / "coronary-phantom-xa/cases"
                                             : std::filesystem::path(arguments.positional().front());
    core::RegistrationOptions options;
    options.method = arguments.text("method", options.method);
    for (const std::string& assignment : arguments.list("set", "")) {
        if (const auto status = core::setOption(options, assignment); !status) {
            std::fprintf(stderr, "%s\n", status.error().message.c_str());
            return 2;
        }
    }
    std::vector<View> views;
    for (const char* name : {"IM1.angiopose", "IM2.angiopose", "IM3.angiopose", "IM4.angiopose"}) {
        auto view = registerView(folder / name, options);
        if (!view) {
            std::fprintf(stderr, "%s\n", view.error().message.c_str());
            return 1;
        }
        views.push_back(std::move(view).value());
    }
    std::printf("Coronary phantom, real XA: default options, automatic tracing, rough start poses\n\n");
    printViews(views);
    std::printf("Rotation between two views\n\n");
    std::vector<double> differences = printPairs(views);
    std::sort(differences.begin(), differences.end());
    const double worstPx = std::max_element(views.begin(), views.end(), [](const View& a, const View& b) {
                               return a.result.metrics.medianPx < b.result.metrics.medianPx;
                           })->result.metrics.medianPx;
    const std::size_t half = differences.size() / 2;
    const bool isNear = printAim("Largest median projection distance", worstPx, largestMedianPx, "px");
    const bool isConsistent =
        printAim("Largest difference of relative rotations", differences.back(), largestDifferenceDeg, "°");
    const bool isTypical = printAim("Median difference of relative rotations",
                                    0.5 * (differences[half - 1] + differences[half]), medianDifferenceDeg, "°");
    return isNear && isConsistent && isTypical ? 0 : 1;
}
