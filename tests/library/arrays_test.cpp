#include "tests/library/small_case.h"
#include "tests/support/german_locale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

namespace angiopose {
namespace {

namespace fs = std::filesystem;

/// Expects two results to be identical to the last bit.
void expectSame(const RegistrationResult& one, const RegistrationResult& other)
{
    EXPECT_EQ(0, std::memcmp(one.cameraFromPatient.data(), other.cameraFromPatient.data(), sizeof(Pose)));
    EXPECT_EQ(0, std::memcmp(&one.metrics, &other.metrics, sizeof(DistanceMetrics)));
    EXPECT_EQ(0, std::memcmp(one.uncertainty.covariance.data(), other.uncertainty.covariance.data(), sizeof(Matrix6d)));
    EXPECT_EQ(one.iterations, other.iterations);
    EXPECT_EQ(one.warnings.size(), other.warnings.size());
}

template <class Work>
std::string idOfErrorIn(const Work& work)
{
    try {
        work();
    } catch (const Error& error) {
        EXPECT_FALSE(std::string(error.what()).empty());
        return error.id();
    }
    return "no error";
}

TEST(Arrays, ACaseAndItsArraysGiveTheSameBits)
{
    Case session = test::smallCase().session;
    const RegistrationInput input = inputOf(session);
    RegistrationOptions options = session.options();
    options.set("geometryErrors", "none");   // a case knows the origin of its geometry, arrays do not
    session.setOptions(options);
    expectSame(registerVessels(input, options), registerCase(session));
}

/// The library reads headers with a decimal point and does not change the locale of the calling program.
TEST(Arrays, VolumesAreReadAlikeUnderAGermanLocale)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write(
        "a.nrrd",
        "NRRD0005\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 2 2\nspace directions: "
        "(1.5,0,0) (0,1.5,0) (0,0,0.8)\nspace origin: (-36.25,0,0)\nendian: little\nencoding: raw\n\n" +
            std::string(16, '\0'));
    const test::GermanLocale german;
    if (!german.isSet()) {
        GTEST_SKIP() << "locale de_DE.UTF-8 is neither installed nor can it be made (package locales)";
    }
    const VolumeGeometry geometry = readVolume(path).geometry();
    EXPECT_LT((geometry.spacingMm - Eigen::Vector3d(1.5, 1.5, 0.8)).norm(), 1e-12) << geometry.spacingMm;
    EXPECT_EQ(geometry.originInPatient.x(), -36.25);
    EXPECT_TRUE(german.isSet());
}

TEST(Arrays, AVolumeWithoutASizeIsRefused)
{
    const std::vector<std::int16_t> voxels(8);
    VolumeGeometry geometry{{2, 2, 2}};
    for (const double spacing : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
        geometry.spacingMm.y() = spacing;
        EXPECT_EQ(idOfErrorIn([&] { (void)Volume(voxels, geometry); }), "library.volume-spacing");
    }
}

TEST(Arrays, OptionsOfACaseSurviveTheWayThroughTexts)
{
    Case session = test::smallCase().session;
    RegistrationOptions options;
    options.method = "dynaweight";
    options.set("priorWeight", 1.0 / 3.0).set("preset", "seed_metric");
    options.locks = {"roll"};
    session.setOptions(options);
    EXPECT_EQ(options.values, session.options().values);
    EXPECT_EQ(options.locks, session.options().locks);
    EXPECT_EQ("dynaweight", session.options().method);
}

/// Median distance of the projected tree from the image points, px.
double medianPx(RegistrationInput input, const VesselTree& tree, const Pose& pose)
{
    input.tree = tree;
    return evaluatePose(input, pose).metrics.medianPx;
}

/// The tree with its far half displaced by up to 4 mm, increasing from the middle on.
VesselTree deformedByHand(VesselTree tree)
{
    double meanZ = 0.0;
    for (const Eigen::Vector3d& point : tree.points) {
        meanZ += point.z() / static_cast<double>(tree.points.size());
    }
    for (Eigen::Vector3d& point : tree.points) {
        point.x() += 4.0 / (1.0 + std::exp((meanZ - point.z()) / 5.0));
    }
    return tree;
}

TEST(Arrays, DeformedVesselsLieNearerToTheImageThanRigidOnes)
{
    RegistrationInput input = inputOf(test::smallCase().session);
    input.tree = deformedByHand(input.tree);
    const RegistrationResult found = registerVessels(input, RegistrationOptions().set("deformable", "always"));
    ASSERT_TRUE(found.deformed);
    EXPECT_EQ("bent", toText(found.deformed->verdict));
    ASSERT_EQ(input.tree.points.size(), found.deformed->displacementMm.size());
    ASSERT_EQ(input.tree.points.size(), found.deformed->covarianceMm2.size());
    ASSERT_EQ(input.tree.branchIds, found.deformed->tree.branchIds);
    ASSERT_EQ(1u, found.deformed->viewPoses.size());
    for (std::size_t i = 0; i < input.tree.points.size(); ++i) {
        const Eigen::Vector3d moved = found.deformed->tree.points[i] - input.tree.points[i];
        EXPECT_LT((moved - found.deformed->displacementMm[i]).norm(), 1e-9);
        EXPECT_GT(found.deformed->covarianceMm2[i](2, 2),
                  found.deformed->covarianceMm2[i](0, 0));   // a single view, along the ray
    }
    EXPECT_LT(medianPx(input, found.deformed->tree, found.deformed->viewPoses.front()), 0.5 * found.metrics.medianPx);
}

TEST(Arrays, VesselsAreNotDeformedWhereNobodyAsks)
{
    const RegistrationInput input = inputOf(test::smallCase().session);
    EXPECT_FALSE(registerVessels(input, RegistrationOptions().set("deformable", "never")).deformed);
}

TEST(Arrays, ImagePointsInNoOrderLeadToTheSamePlace)
{
    const SimulatedCase simulated = test::smallCase();
    RegistrationInput input = inputOf(simulated.session);
    const RegistrationResult ordered = registerVessels(input);
    input.target.curveIds.clear();
    input.target.radiusPx.clear();
    std::ranges::shuffle(input.target.points, std::mt19937(1));
    const RegistrationResult unordered = registerVessels(input);
    EXPECT_LT(unordered.metrics.medianPx, 1.5 * ordered.metrics.medianPx + 0.2);
}

TEST(Arrays, UnknownRadiiStayUnknown)
{
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    VesselTree tree{
        {{0, 0, 0}, {1, 0, 0}, {5, 5, 5}, {5, 6, 5}}, {3, 3, 8, 8}, {1.5, 1.25, unknown, unknown}, {{8, "side", 1}}};
    const fs::path file = fs::temp_directory_path() / "angiopose-arrays-test.csv";
    writeVesselTree(tree, file.string());
    const VesselTree read = readVesselTree(file.string());
    fs::remove(file);
    ASSERT_EQ(tree.points.size(), read.points.size());
    EXPECT_EQ(tree.branchIds, read.branchIds);
    ASSERT_EQ(4U, read.radiusMm.size());
    EXPECT_EQ(1.25, read.radiusMm[1]);
    EXPECT_TRUE(std::isnan(read.radiusMm[2]) || read.radiusMm[2] == 0.0);
}

TEST(Arrays, WhatDoesNotFitTogetherIsSaid)
{
    const RegistrationInput good = inputOf(test::smallCase().session);
    RegistrationInput input = good;
    input.tree.branchIds.pop_back();
    EXPECT_EQ("library.lengths-differ", idOfErrorIn([&] { registerVessels(input); }));
    input = good;
    std::swap(input.tree.branchIds.front(), input.tree.branchIds.back());
    EXPECT_EQ("library.points-apart", idOfErrorIn([&] { registerVessels(input); }));
    input = good;
    input.initialCameraFromPatient(3, 0) = 1.0;
    EXPECT_EQ("library.no-pose", idOfErrorIn([&] { registerVessels(input); }));
    Pose scaled = good.initialCameraFromPatient;
    scaled.topLeftCorner<3, 3>() *= 2.0;
    EXPECT_EQ("library.no-pose", idOfErrorIn([&] { writePose(scaled, "never-written.json"); }));
    input = good;
    input.image.pixels.pop_back();
    EXPECT_EQ("library.image-size", idOfErrorIn([&] { registerVessels(input); }));
    EXPECT_EQ("library.no-option",
              idOfErrorIn([&] { registerVessels(good, RegistrationOptions().set("maxIteration", 5)); }));
    EXPECT_NE("no error", idOfErrorIn([&] { registerVessels(good, RegistrationOptions().set("maxIterations", -5)); }));
    EXPECT_NE("no error", idOfErrorIn([] { readCase("no-such-file.angiopose"); }));
}

TEST(Arrays, TheCovarianceIsAboutThePlaceItNames)
{
    const RegistrationInput input = inputOf(test::smallCase().session);
    const RegistrationResult result = evaluatePose(input, input.initialCameraFromPatient);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();   // weighted by length
    double length = 0.0;
    for (std::size_t i = 1; i < input.tree.points.size(); ++i) {
        if (input.tree.branchIds[i] == input.tree.branchIds[i - 1]) {
            const double step = (input.tree.points[i] - input.tree.points[i - 1]).norm();
            sum += 0.5 * step * (input.tree.points[i] + input.tree.points[i - 1]);
            length += step;
        }
    }
    EXPECT_LT((result.uncertainty.centroidInPatient - sum / length).norm(), 1e-9);
    EXPECT_EQ("converged", toText(result.stopReason));
}

TEST(Arrays, WhatMakesNoSenseIsRefused)
{
    const RegistrationInput good = inputOf(test::smallCase().session);
    RegistrationInput input = good;
    input.tree.radiusMm[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ("tree.branch-radius-unusable", idOfErrorIn([&] { registerVessels(input); }));
    input = good;
    input.initialCameraFromPatient = Pose::Identity();
    EXPECT_EQ("input.start-pose-behind-source", idOfErrorIn([&] { registerVessels(input); }));
    EXPECT_EQ("options.needs-whole-number",
              idOfErrorIn([&] { registerVessels(good, RegistrationOptions().set("maxIterations", 40.5)); }));
    EXPECT_EQ("library.no-frames", idOfErrorIn([] { Angiogram({}, Polarity::VesselsDark); }));
    SimulationOptions options;
    options.branchCount = 0;
    EXPECT_EQ("simulation.out-of-range", idOfErrorIn([&] { simulateCase(1, options); }));
}

TEST(Arrays, EveryMethodIsListedWithOptionsThatCanBeSet)
{
    const auto all = methods();
    ASSERT_GT(all.size(), 5U);
    EXPECT_EQ("angiopose", all.front().id);
    Case session = test::smallCase().session;
    for (const MethodInfo& method : all) {
        RegistrationOptions options;
        options.method = method.id;
        for (const OptionInfo& option : method.options) {
            options.set(option.key, std::string_view(option.defaultValue));
        }
        session.setOptions(options);
        EXPECT_TRUE(session.options().values.empty()) << method.id;
    }
}

}   // namespace
}   // namespace angiopose
