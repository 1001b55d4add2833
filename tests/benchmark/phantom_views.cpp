#include "tests/benchmark/phantom_views.h"

#include "core/case/registration_input.h"
#include "core/support/quantile.h"
#include "io/case/case_file.h"

#include <algorithm>
#include <chrono>
#include <numbers>

namespace angiopose::benchmarks {
namespace {

double milliseconds(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

core::Result<PhantomView> registerView(const std::filesystem::path& path, const core::RegistrationOptions& options)
{
    core::Messages warnings;
    auto loaded = io::loadCase(path.string(), warnings);
    if (!loaded) {
        return loaded.error();
    }
    core::Case session = std::move(loaded).value();
    session.options = options;
    const auto headerPose = core::cameraFromPatient(session.shown().geometry.cArm, Eigen::Vector3d::Zero());
    if (!headerPose) {
        return headerPose.error();
    }
    const auto begin = std::chrono::steady_clock::now();
    auto target = core::targetOf(session.shown());
    if (!target) {
        return target.error();
    }
    PhantomView view;
    view.traceMs = milliseconds(begin);
    auto input = core::makeRegistrationInput(session, std::move(target).value());
    if (!input) {
        return input.error();
    }
    view.input = std::move(input).value();
    auto result = core::registerVessels(view.input, session.options);
    if (!result) {
        return result.error();
    }
    view.name = path.stem().string();
    view.primaryDeg = session.shown().geometry.cArm.primaryAngleDeg.value.value_or(0.0);
    view.secondaryDeg = session.shown().geometry.cArm.secondaryAngleDeg.value.value_or(0.0);
    view.sourceToPatientMm = session.shown().geometry.cArm.sourceToIsocenterMm.value.value_or(0.0);
    view.headerRotation = headerPose.value().rotation;
    view.result = std::move(result).value();
    view.depthMm = (view.result.cameraFromPatient * core::centroidInPatient(*session.vessels.tree)).z();
    return view;
}

std::vector<double> differencesOf(const std::vector<PhantomPair>& pairs)
{
    std::vector<double> differences;
    for (const PhantomPair& pair : pairs) {
        differences.push_back(pair.differenceDeg);
    }
    return differences;
}

}   // namespace

double inDegrees(double radians)
{
    return radians * 180.0 / std::numbers::pi;
}

std::filesystem::path phantomFolder()
{
    return std::filesystem::path(TEST_DATA_DIR) / "coronary-phantom-xa/cases";
}

core::Result<std::vector<PhantomView>> registerPhantom(const std::filesystem::path& folder,
                                                       const core::RegistrationOptions& options)
{
    std::vector<PhantomView> views;
    for (const char* name : {"IM1.angiopose", "IM2.angiopose", "IM3.angiopose", "IM4.angiopose"}) {
        auto view = registerView(folder / name, options);
        if (!view) {
            return view.error();
        }
        views.push_back(std::move(view).value());
    }
    return views;
}

std::vector<Eigen::Matrix3d> registeredRotations(const std::vector<PhantomView>& views)
{
    std::vector<Eigen::Matrix3d> rotations;
    for (const PhantomView& view : views) {
        rotations.push_back(view.result.cameraFromPatient.rotation);
    }
    return rotations;
}

std::vector<Eigen::Matrix3d> headerRotations(const std::vector<PhantomView>& views)
{
    std::vector<Eigen::Matrix3d> rotations;
    for (const PhantomView& view : views) {
        rotations.push_back(view.headerRotation);
    }
    return rotations;
}

std::vector<PhantomPair> pairsOf(const std::vector<Eigen::Matrix3d>& rotations,
                                 const std::vector<Eigen::Matrix3d>& expected)
{
    const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
    std::vector<PhantomPair> pairs;
    for (std::size_t a = 0; a < rotations.size(); ++a) {
        for (std::size_t b = a + 1; b < rotations.size(); ++b) {
            const Eigen::Matrix3d found = rotations[b] * rotations[a].transpose();
            const Eigen::Matrix3d reported = expected[b] * expected[a].transpose();
            pairs.push_back({a, b, inDegrees(core::angleBetween(found, none)),
                             inDegrees(core::angleBetween(reported, none)),
                             inDegrees(core::angleBetween(found, reported))});
        }
    }
    return pairs;
}

double medianDifferenceDeg(const std::vector<PhantomPair>& pairs)
{
    return core::quantile(differencesOf(pairs), 0.5);
}

double largestDifferenceDeg(const std::vector<PhantomPair>& pairs)
{
    return core::quantile(differencesOf(pairs), 1.0);
}

}   // namespace angiopose::benchmarks
