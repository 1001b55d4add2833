#include "core/evaluation/trial/projection_error.h"
#include "core/imaging/volume.h"
#include "core/registration/methods/method.h"
#include "core/registration/picture/drr.h"
#include "core/registration/picture/rank_correlation.h"
#include "core/registration/picture/tube_image.h"
#include "core/registration/picture/vessel_brightness.h"
#include "core/registration/picture/vessel_image.h"
#include "core/registration/picture/wall_sites.h"
#include "core/simulation/simulated_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <map>

using namespace angiopose;

// Tests of the image-based methods: the image content they use and whether they use it.

namespace {

using namespace core;

/// A tree 800 mm from the source in a 256² image, with an initial pose that is off by 2° and 5 mm.
struct DrawnCase {
    explicit DrawnCase(std::uint64_t seed = 3)
    {
        tree = simulateTree(seed, {8, 90.0, 3.0, 2.0});
        truth.rotation = expSo3(Eigen::Vector3d(0.4, 0.3, -0.2));
        truth.translation = Eigen::Vector3d(4.0, -6.0, 800.0) - truth.rotation * centroidInPatient(tree);
        input.tree = tree;
        input.camera = {-1200.0, 1200.0, 127.5, 127.5, 256, 256};
        input.target = projectTree(tree, input.camera, truth);
        CounterRandom random(seed);
        input.initialCameraFromPatient = perturbAboutCentroid(truth, centroidInPatient(tree), 1.0, 3.0, random);
    }

    /// Adds the angiogram: dark vessels on a bright field. The target is a single stray point that no method may need.
    void showImage()
    {
        const RegistrationProblem drawn = problem();
        ImageF image = renderTubes(drawn.tree, input.camera, truth);
        for (float& value : image.pixels) {
            value = 1000.0F - 20.0F * value;
        }
        input.image = std::make_shared<const ImageF>(std::move(image));
        input.target.curves = {{0, {Eigen::Vector2d(128.0, 128.0)}, {}}};
    }

    RegistrationProblem problem() const { return makeProblem(input, {}).value(); }
    double meanPx(const RigidTransform& pose) const
    {
        return projectionError(tree, input.camera, {pose, truth}).meanPx;
    }

    VesselTree tree;
    RigidTransform truth;
    RegistrationInput input;
};

RigidTransform poseBy(const RegistrationInput& input, const RegistrationOptions& options)
{
    const IterationObserver none;
    const RegistrationProblem problem = makeProblem(input, options).value();
    ProgressLog progress(problem, none);
    return findMethod(options.method)->solve(problem, options, progress).cameraFromPatient;
}

RegistrationOptions brightnessOptions(std::string_view method)
{
    RegistrationOptions options;
    options.method = method;
    options.nicp.image = NicpImage::Brightness;
    return options;
}

TEST(ImageMethods, ReadTheAngiogramNotTheTarget)
{
    DrawnCase drawn;
    drawn.showImage();
    const std::map<std::string_view, double> limitsPx{
        {"rgbr", 0.9}, {"automask", 1.35}, {"gradient-matching", 0.75}, {"evolution", 1.45}, {"nicp", 1.15}};
    for (const auto& [method, limitPx] : limitsPx) {
        const RigidTransform pose = poseBy(drawn.input, brightnessOptions(method));
        EXPECT_LT(drawn.meanPx(pose), limitPx) << method;
    }
}

// Brightness and edges reach only a few vessel radii (ALGORITHMS §3.4, §3.10), so these methods fail from farther away.
TEST(ImageMethods, DoNotFindVesselsFarFromTheStart)
{
    DrawnCase drawn;
    drawn.input.initialCameraFromPatient =
        RigidTransform{Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.0, 60.0, 0.0)} * drawn.truth;
    for (const std::string_view method : {"gradient-matching", "nicp"}) {
        EXPECT_GT(drawn.meanPx(poseBy(drawn.input, brightnessOptions(method))), 10.0) << method;
    }
}

TEST(VesselPicture, IsTheSameForEitherPolarity)
{
    DrawnCase drawn;
    drawn.showImage();
    const ImageF dark = vesselImage(drawn.problem());
    ImageF inverted = *drawn.input.image;
    for (float& value : inverted.pixels) {
        value = -value;
    }
    drawn.input.image = std::make_shared<const ImageF>(std::move(inverted));
    drawn.input.polarity = Polarity::VesselsBright;
    EXPECT_EQ(vesselImage(drawn.problem()).pixels, dark.pixels);
}

TEST(VesselPicture, IsBrightOnTheVesselsWithOrWithoutAnImage)
{
    DrawnCase drawn;
    const RegistrationProblem traced = drawn.problem();
    const ImageF ofTarget = vesselImage(traced);
    drawn.showImage();
    const ImageF ofImage = vesselImage(drawn.problem());
    for (const ImageF* picture : {&ofTarget, &ofImage}) {
        double on = 0.0;
        for (const Eigen::Vector2d& point : traced.target.points) {
            on += picture->at(static_cast<int>(std::lround(point.x())), static_cast<int>(std::lround(point.y())));
        }
        on /= static_cast<double>(traced.target.size());
        double all = 0.0;
        for (const float value : picture->pixels) {
            all += value;
        }
        EXPECT_GT(on, 5.0 * all / static_cast<double>(picture->pixels.size()));
    }
}

TEST(RegistrationProblem, RefusesAnImageOfAnotherSize)
{
    DrawnCase drawn;
    drawn.input.image = std::make_shared<const ImageF>(100, 90);
    EXPECT_FALSE(makeProblem(drawn.input, {}));
}

TEST(DrawTube, ShowsTheChordsOfATube)
{
    ImageF image(40, 40);
    drawTube(image, {5.0, 20.0}, {35.0, 20.0}, 4.5);
    EXPECT_NEAR(image.at(20, 20), 10.0, 1e-5);
    EXPECT_NEAR(image.at(20, 23), 8.0, 1e-5);
    EXPECT_EQ(image.at(20, 26), 0.0F);
    EXPECT_EQ(image.at(20, 14), 0.0F);
}

/// A CTA of the tree: contrast agent in tissue.
std::shared_ptr<const Volume> ctaOf(const VesselTree& tree)
{
    VolumeGeometry geometry;
    geometry.spacingMm = {1.0, 0.8, 1.2};
    geometry.size = {120, 150, 100};
    geometry.originInPatient = centroidInPatient(tree) - Eigen::Vector3d(60.0, 60.0, 60.0);
    Volume volume(geometry, 40);
    for (const VesselBranch& branch : tree.branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d center = geometry.patientFromVoxel().inverse() * branch.pointsInPatient[i];
            const int reach = 5;
            for (int part = 0; part < (2 * reach + 1) * (2 * reach + 1) * (2 * reach + 1); ++part) {
                const Eigen::Vector3i voxel =
                    center.array().round().cast<int>().matrix() +
                    Eigen::Vector3i(part % 11 - reach, part / 11 % 11 - reach, part / 121 - reach);
                const Eigen::Vector3d offset = geometry.spacingMm.cwiseProduct(voxel.cast<double>() - center);
                if (geometry.contains(voxel) && offset.norm() <= branch.radiusMm[i]) {
                    volume.at(voxel.x(), voxel.y(), voxel.z()) = 400;
                }
            }
        }
    }
    return std::make_shared<const Volume>(std::move(volume));
}

TEST(Drr, OfACtaIsLikeThatOfItsTubes)
{
    DrawnCase drawn;
    const ImageF tubes = Drr(drawn.problem()).from(drawn.truth);
    drawn.input.volume = ctaOf(drawn.tree);
    const RegistrationProblem problem = drawn.problem();
    const ImageF cta = Drr(problem).from(drawn.truth);
    const ImageF elsewhere = Drr(problem).from(drawn.input.initialCameraFromPatient);
    EXPECT_GT(rankCorrelation(tubes.pixels, cta.pixels), 0.8);
    EXPECT_LT(rankCorrelation(tubes.pixels, elsewhere.pixels), rankCorrelation(tubes.pixels, cta.pixels));
}

TEST(AutoMask, RegistersACta)
{
    DrawnCase drawn;
    drawn.input.volume = ctaOf(drawn.tree);
    EXPECT_LT(drawn.meanPx(poseBy(drawn.input, brightnessOptions("automask"))), 0.6);
}

TEST(RankCorrelation, KnowsOrderAndNothingElse)
{
    std::vector<float> rising;
    std::vector<float> cubed;
    std::vector<float> falling;
    for (int i = 0; i < 200; ++i) {
        rising.push_back(static_cast<float>(i));
        cubed.push_back(std::pow(static_cast<float>(i) / 200.0F + 0.5F, 3.0F));
        falling.push_back(-static_cast<float>(i));
    }
    EXPECT_NEAR(rankCorrelation(rising, rising), 1.0, 1e-12);
    EXPECT_NEAR(rankCorrelation(rising, cubed), 1.0, 1e-3);
    EXPECT_NEAR(rankCorrelation(rising, falling), -1.0, 1e-3);
    EXPECT_EQ(rankCorrelation(rising, std::vector<float>(200, 3.0F)), 0.0);
}

TEST(WallSites, LieOnTheWallsAndAgreeMostAtTheTruth)
{
    const DrawnCase drawn;
    const RegistrationProblem problem = drawn.problem();
    const std::vector<WallSite> sites = wallSites(problem.tree, 1000);
    EXPECT_LE(sites.size(), 1008U);
    for (const WallSite& site : sites) {
        EXPECT_NEAR(site.normal.norm(), 1.0, 1e-12);
    }
    const BackprojectedGradients gradients(vesselImage(problem), drawn.input.camera, 1.0);
    const CentroidPose truth = aboutCentroid(drawn.truth, problem.tree.centroid);
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = (k < 3 ? 0.03 : (k < 5 ? 2.0 : 30.0)) * Vector6d::Unit(k);
        EXPECT_GT(gradients.score(sites, truth), gradients.score(sites, retract(truth, step))) << k;
        EXPECT_GT(gradients.score(sites, truth), gradients.score(sites, retract(truth, -step))) << k;
    }
}

TEST(VesselBrightness, PullLeadsUphill)
{
    const DrawnCase drawn;
    const RegistrationProblem problem = drawn.problem();
    const VesselBrightness brightness(problem);
    const CentroidPose truth = aboutCentroid(drawn.truth, problem.tree.centroid);
    for (int k = 3; k < 5; ++k) {
        const CentroidPose off = retract(truth, 1.5 * Vector6d::Unit(k));
        const Vector6d direction = dampedStep(brightness.normalEquations(off, 2.0), 1e-3);
        EXPECT_LT(direction(k), 0.0);
        const CentroidPose next = retract(off, 0.2 / direction.tail<3>().norm() * direction);
        EXPECT_GT(brightness.meanAt(next, 2.0), brightness.meanAt(off, 2.0));
    }
}

}   // namespace
