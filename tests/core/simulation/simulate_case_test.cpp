#include "core/geometry/geometry_checks.h"
#include "core/simulation/simulated_case.h"
#include "tests/support/matchers.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace angiopose;

namespace {

using namespace core;

constexpr double midGray = 2048.0;

/// Vessels only: no noise, motion, catheter, extra vessels or shutter.
DsaOptions cleanDsa()
{
    DsaOptions options;
    options.frameCount = 1;
    options.photonCount = 1e9;
    options.maskMotionPx = 0.0;
    options.catheterProbability = 0.0;
    options.extraBranchShare = 0.0;
    options.shutterProbability = 0.0;
    return options;
}

double distanceToOthers(const Centerline2d& target, int exceptId, const Eigen::Vector2d& pixel)
{
    double nearest = std::numeric_limits<double>::max();
    for (const Curve2d& curve : target.curves) {
        if (curve.id == exceptId) {
            continue;
        }
        for (const Eigen::Vector2d& other : curve.pointsPx) {
            nearest = std::min(nearest, (other - pixel).norm());
        }
    }
    return nearest;
}

bool isWellInside(const ImageF& image, const Eigen::Vector2d& pixel)
{
    return pixel.x() > 15 && pixel.y() > 15 && pixel.x() < image.width - 15 && pixel.y() < image.height - 15;
}

float bilinear(const ImageF& image, const Eigen::Vector2d& pixel)
{
    const int x = static_cast<int>(pixel.x());
    const int y = static_cast<int>(pixel.y());
    const auto fx = static_cast<float>(pixel.x() - x);
    const auto fy = static_cast<float>(pixel.y() - y);
    return (1 - fy) * ((1 - fx) * image.at(x, y) + fx * image.at(x + 1, y)) +
           fy * ((1 - fx) * image.at(x, y + 1) + fx * image.at(x + 1, y + 1));
}

/// Signed distance from a centerline point to the darkest point across the vessel.
double ridgeOffset(const ImageF& image, const Eigen::Vector2d& pixel, const Eigen::Vector2d& tangent, double reachPx)
{
    const Eigen::Vector2d normal(-tangent.y(), tangent.x());
    double weight = 0.0;
    double moment = 0.0;
    for (double s = -reachPx; s <= reachPx; s += 0.25) {
        const double dark = std::max(0.0, midGray - bilinear(image, pixel + s * normal));
        weight += dark;
        moment += s * dark;
    }
    return weight > 0.0 ? moment / weight : std::numeric_limits<double>::infinity();
}

TEST(SimulateCase, SameSeedSameBitsOtherSeedOtherCase)
{
    DsaOptions small;
    small.width = small.height = 160;
    small.frameCount = 2;
    const SimulatedCase a = simulateCase(3, {}, small);
    const SimulatedCase b = simulateCase(3, {}, small);
    const SimulatedCase c = simulateCase(4, {}, small);
    ASSERT_EQ(a.angiogram.frameCount(), 2);
    EXPECT_EQ(a.angiogram.frames[1].pixels, b.angiogram.frames[1].pixels);
    EXPECT_EQ(a.trueCameraFromPatient.matrix(), b.trueCameraFromPatient.matrix());
    EXPECT_EQ(a.initialCameraFromPatient.matrix(), b.initialCameraFromPatient.matrix());
    EXPECT_EQ(a.missingBranchIds, b.missingBranchIds);
    EXPECT_NE(a.angiogram.frames[1].pixels, c.angiogram.frames[1].pixels);
}

TEST(SimulateCase, TheProjectedCenterlineLiesOnTheDarkRidge)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const SimulatedCase simulated = simulateCase(seed, {}, cleanDsa());
        const ImageF& frame = simulated.angiogram.frames.front();
        std::vector<double> offsets;
        for (const Curve2d& curve : simulated.trueTarget.curves) {
            const auto tangents = tangentsOf(curve.pointsPx);
            for (std::size_t i = 10; i + 10 < curve.pointsPx.size(); ++i) {
                const double reach = curve.radiusPx[i] + 3.0;
                if (isWellInside(frame, curve.pointsPx[i]) &&
                    distanceToOthers(simulated.trueTarget, curve.id, curve.pointsPx[i]) > 2.0 * reach + 4.0) {
                    offsets.push_back(ridgeOffset(frame, curve.pointsPx[i], tangents[i], reach));
                }
            }
        }
        ASSERT_GT(offsets.size(), 200u) << seed;
        std::sort(offsets.begin(), offsets.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
        EXPECT_LT(std::abs(offsets[offsets.size() / 2]), 0.1) << seed;
        EXPECT_LT(std::abs(offsets[offsets.size() * 95 / 100]), 0.3) << seed;
    }
}

TEST(SimulateCase, MissingBranchesAreInvisibleAndTheOthersShow)
{
    const SimulatedCase simulated = simulateCase(5, {}, cleanDsa());
    const ImageF& frame = simulated.angiogram.frames.front();
    ASSERT_EQ(simulated.missingBranchIds.size(), 5u);   // 0.2 of 24 branches
    const Centerline2d all = projectTree(simulated.tree, simulated.camera, simulated.trueCameraFromPatient);
    int checkedMissing = 0;
    int dark = 0;
    int filled = 0;
    for (const Curve2d& curve : all.curves) {
        const auto& ids = simulated.missingBranchIds;
        const bool isMissing = std::find(ids.begin(), ids.end(), curve.id) != ids.end();
        for (std::size_t i = 8; i + 16 < curve.pointsPx.size(); ++i) {
            const Eigen::Vector2d& pixel = curve.pointsPx[i];
            if (!isWellInside(frame, pixel)) {
                continue;
            }
            if (!isMissing) {
                ++filled;
                dark += bilinear(frame, pixel) < midGray - 30.0 ? 1 : 0;
            } else if (distanceToOthers(simulated.trueTarget, -1, pixel) > 10.0) {
                ++checkedMissing;
                // Scatter from the opacified vessels slightly brightens their surroundings.
                EXPECT_NEAR(bilinear(frame, pixel), midGray, 25.0);
            }
        }
        EXPECT_EQ(isMissing, std::none_of(simulated.trueTarget.curves.begin(), simulated.trueTarget.curves.end(),
                                          [&](const Curve2d& visible) { return visible.id == curve.id; }));
    }
    EXPECT_GT(checkedMissing, 30);
    EXPECT_GT(dark, 0.97 * filled);
}

TEST(SimulateCase, LooksLikeAnExportedRun)
{
    DsaOptions options;
    options.width = 200;
    options.height = 160;
    options.shutterProbability = 1.0;
    const SimulatedCase simulated = simulateCase(6, {}, options);
    const Angiogram& angiogram = simulated.angiogram;
    EXPECT_EQ(angiogram.polarity, Polarity::VesselsDark);
    ASSERT_EQ(angiogram.frameCount(), 8);
    EXPECT_EQ(angiogram.width(), 200);
    EXPECT_EQ(angiogram.height(), 160);
    EXPECT_GT(angiogram.suggestedFrame, 0);
    EXPECT_LT(angiogram.suggestedFrame, 7);
    EXPECT_EQ(angiogram.frames[0].at(0, 0), 0.0F);   // behind the shutter
    for (const float value : angiogram.frames[3].pixels) {
        EXPECT_EQ(value, std::round(value));
        EXPECT_GE(value, 0.0F);
        EXPECT_LE(value, 4095.0F);
    }
}

TEST(SimulateCase, ThePeakFrameShowsMoreVesselThanTheFirstAndTheLast)
{
    DsaOptions options = cleanDsa();
    options.frameCount = 8;
    const Angiogram angiogram = simulateCase(2, {}, options).angiogram;
    const auto darkness = [&](int frame) {
        double sum = 0.0;
        for (const float value : angiogram.frames[static_cast<std::size_t>(frame)].pixels) {
            sum += std::max(0.0, midGray - value);
        }
        return sum;
    };
    EXPECT_GT(darkness(angiogram.suggestedFrame), 3.0 * darkness(0));
    EXPECT_GT(darkness(angiogram.suggestedFrame), 3.0 * darkness(7));
}

TEST(SimulateCase, TheContrastMediumKeepsToItsTiming)
{
    DsaOptions options = cleanDsa();
    options.frameCount = 6;
    options.timing.firstS = 0.9;   // the run starts late and ends before the contrast agent washes out
    options.timing.injectionS = 10.0;
    EXPECT_GE(simulateCase(2, {}, options).angiogram.suggestedFrame, 1);   // opacified by then
    options.timing.firstS = 10.5;
    EXPECT_EQ(simulateCase(2, {}, options).angiogram.suggestedFrame, 0);   // washout only
    options.timing = {.firstS = 0.0, .runS = 0.6, .fillingS = 3.0};
    EXPECT_EQ(simulateCase(2, {}, options).angiogram.suggestedFrame, 5);   // wash-in only
    EXPECT_EQ(simulateCase(2, {}, options).angiogram.frameTimeMs, 100.0);
}

TEST(SimulateCase, OneBranchOneFrameStillMakesACase)
{
    DsaOptions options;
    options.width = 120;
    options.height = 90;
    options.frameCount = 1;
    const SimulatedCase simulated = simulateCase(1, {.branchCount = 1}, options);
    EXPECT_EQ(simulated.angiogram.frameCount(), 1);
    EXPECT_EQ(simulated.angiogram.frameTimeMs, 0.0);
    EXPECT_TRUE(simulated.missingBranchIds.empty());
    EXPECT_GE(simulated.trueTarget.curves.size(), 1u);
}

TEST(SimulateCase, NamesWhatCannotBeSimulated)
{
    EXPECT_FALSE(findProblem(TreeOptions{}, DsaOptions{}));
    EXPECT_EQ(findProblem({.branchCount = 0}, {})->text(),
              "The branchCount of the simulation must be between 1 and 200, not 0.");
    EXPECT_TRUE(findProblem({}, {.frameCount = 0}));
    EXPECT_TRUE(findProblem({}, {.missingBranchShare = 2.0}));
    EXPECT_TRUE(findProblem({}, {.nonRigidStdMm = std::numeric_limits<double>::quiet_NaN()}));
}

TEST(SimulateCase, NoiseFollowsThePhotonCount)
{
    const auto noiseOf = [](double photons) {
        DsaOptions options = cleanDsa();
        options.photonCount = photons;
        const ImageF frame = simulateCase(8, {}, options).angiogram.frames.front();
        double squares = 0.0;   // squared differences along the top rows, where there is no vessel
        for (int x = 2; x < frame.width; ++x) {
            squares += std::pow(frame.at(x, 2) - frame.at(x - 2, 2), 2) / 2.0;
        }
        return std::sqrt(squares / (frame.width - 2));
    };
    EXPECT_NEAR(noiseOf(1000.0) / noiseOf(9000.0), 3.0, 0.6);
}

TEST(SimulateCase, StartsWhereAHeaderWouldPutIt)
{
    DsaOptions small;
    small.width = small.height = 192;
    small.frameCount = 1;
    double angles = 0.0;
    double lateral = 0.0;
    double depth = 0.0;
    constexpr int cases = 60;
    for (int seed = 0; seed < cases; ++seed) {
        const SimulatedCase s = simulateCase(static_cast<std::uint64_t>(seed), {.branchCount = 3}, small);
        EXPECT_EQ(s.angiogram.cArm.sourceToDetectorMm.origin, Origin::Header);
        EXPECT_TRUE(findContradictions(s.angiogram.cArm).empty());
        const auto camera = cameraFromCArm(s.angiogram.cArm, 192, 192);
        ASSERT_TRUE(camera);
        EXPECT_EQ(camera.value(), s.camera);
        const double angle = angleBetween(s.trueCameraFromPatient.rotation, s.initialCameraFromPatient.rotation);
        angles += angle * angle;
        const Eigen::Vector3d centroid = centroidInPatient(s.tree);
        const Eigen::Vector3d error = s.initialCameraFromPatient * centroid - s.trueCameraFromPatient * centroid;
        lateral += error.head<2>().squaredNorm() / 2.0;
        depth += error.z() * error.z();
    }
    EXPECT_NEAR(std::sqrt(angles / cases) * 180.0 / std::numbers::pi, std::sqrt(3.0),
                0.35);   // 1° about each of three axes
    EXPECT_NEAR(std::sqrt(lateral / cases), 15.0, 3.0);
    EXPECT_NEAR(std::sqrt(depth / cases), 30.0, 7.0);
}

/// Points at every fortieth of the curve's length, the same number for any sampling.
std::vector<Eigen::Vector2d> inEvenShares(const Curve2d& curve)
{
    return resampled(Centerline2d{{curve}}, curve.lengthPx() / 40.0).curves.front().pointsPx;
}

TEST(SimulateCase, ABentVesselStillHasABestRigidPose)
{
    DsaOptions options = cleanDsa();
    options.width = options.height = 128;
    options.missingBranchShare = 0.0;
    options.nonRigidStdMm = 2.0;
    const SimulatedCase deformed = simulateCase(7, {}, options);
    options.nonRigidStdMm = 0.0;
    const SimulatedCase rigid = simulateCase(7, {}, options);
    const auto meanErrorPx = [&](const RigidTransform& pose) {
        const Centerline2d projected = projectTree(deformed.tree, deformed.camera, pose);
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t c = 0; c < projected.curves.size(); ++c) {
            const std::vector<Eigen::Vector2d> found = inEvenShares(projected.curves[c]);
            const std::vector<Eigen::Vector2d> truth = inEvenShares(deformed.trueTarget.curves[c]);
            for (std::size_t i = 0; i < found.size(); ++i) {
                sum += (found[i] - truth[i]).squaredNorm();
                count += 1.0;
            }
        }
        return std::sqrt(sum / count);
    };
    EXPECT_GT(meanErrorPx(deformed.trueCameraFromPatient), 0.1);
    EXPECT_LT(meanErrorPx(deformed.trueCameraFromPatient), meanErrorPx(rigid.trueCameraFromPatient));
    EXPECT_TRUE(test::nearPose(deformed.trueCameraFromPatient, rigid.trueCameraFromPatient, 8.0, 40.0));
    EXPECT_LT(meanErrorPx(rigid.trueCameraFromPatient), 4.0);
}

}   // namespace
