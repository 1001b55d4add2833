#include "core/simulation/paint_torso.h"
#include "core/simulation/smooth_path.h"
#include "tests/support/bodies/body_shapes.h"
#include "tests/support/bodies/simulate_body.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr double heartMuscleHu = 105.0;
constexpr double epicardialFatHu = -80.0;
constexpr double grooveShare = -0.45;   // atrioventricular groove along the long axis, base −1 to apex 1
constexpr double outsideMm = 2.5;   // distance from the muscle to the axis of an artery in the fat
constexpr double rootWidthMm = 14.0;

/// The muscle surface with coordinates: `share` along the axis, −1 at the base, 1 at the apex; `angleDeg` about it, 0
/// at the front, positive to the left.
struct HeartSurface {
    TurnedEllipsoid muscle;

    Eigen::Vector3d at(double share, double angleDeg, double offMm = outsideMm) const
    {
        const double angle = angleDeg * std::numbers::pi / 180.0;
        const double across = std::sqrt(std::max(0.0, 1.0 - share * share));
        const Eigen::Vector3d unit(across * std::cos(angle), across * std::sin(angle), share);
        const Eigen::Vector3d place = unit.cwiseProduct(muscle.halfAxesMm);
        const Eigen::Vector3d outward = unit.cwiseQuotient(muscle.halfAxesMm).normalized();
        return muscle.center + muscle.axes * (place + offMm * outward);
    }
};

HeartSurface drawSurface(CounterRandom& random)
{
    const Eigen::Vector3d towardsApex =
        Eigen::Vector3d(0.6 + 0.08 * random.normal(), -0.55 + 0.08 * random.normal(), -0.6).normalized();
    const Eigen::Vector3d front = Eigen::Vector3d(0.0, -1.0, 0.0);
    const Eigen::Vector3d forward = (front - front.dot(towardsApex) * towardsApex).normalized();
    Eigen::Vector3d leftward = towardsApex.cross(forward);
    leftward *= leftward.x() < 0.0 ? -1.0 : 1.0;
    HeartSurface surface;
    surface.muscle.axes << forward, leftward, towardsApex;
    surface.muscle.halfAxesMm = Eigen::Vector3d(33.0, 37.0, 50.0) * random.uniform(0.9, 1.1);
    return surface;
}

/// A slightly swaying path over the surface.
std::vector<Eigen::Vector3d> wayOver(const HeartSurface& surface, const Eigen::Vector2d& from,
                                     const Eigen::Vector2d& to, CounterRandom& random)
{
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double waves = random.uniform(1.0, 2.5);
    const double roughMm = (surface.at(to.x(), to.y()) - surface.at(from.x(), from.y())).norm();
    const int steps = std::max(8, static_cast<int>(1.6 * roughMm));
    std::vector<Eigen::Vector3d> points;
    for (int n = 0; n <= steps; ++n) {
        const double t = static_cast<double>(n) / steps;
        const Eigen::Vector2d at = from + t * (to - from);
        const double sway = std::sin(std::numbers::pi * t) * std::sin(2.0 * std::numbers::pi * waves * t + phase);
        points.push_back(surface.at(at.x() + 0.025 * sway, at.y() + 3.0 * sway));
    }
    return points;
}

/// The first artery, from the aortic wall into the groove and then over the surface.
std::vector<Eigen::Vector3d> fromRoot(const Eigen::Vector3d& wall, const Eigen::Vector3d& outward,
                                      std::vector<Eigen::Vector3d> onSurface, CounterRandom& random)
{
    const Eigen::Vector3d arrival = (onSurface[2] - onSurface.front()).normalized();
    std::vector<Eigen::Vector3d> points = smoothPath({wall, onSurface.front(), outward, arrival, 0.1}, random);
    points.insert(points.end(), onSurface.begin() + 1, onSurface.end());
    return points;
}

/// Point at the given share of the length of `parent`, where a branch originates.
const Eigen::Vector3d& placeAlong(const VesselBranch& parent, double share)
{
    const double last = static_cast<double>(parent.pointsInPatient.size() - 1);
    return parent.pointsInPatient[static_cast<std::size_t>(std::lround(share * last))];
}

/// Adds a side branch that ends at a point of the surface.
void addSide(VesselTree& tree, std::size_t parent, double share, const Eigen::Vector3d& end, double radiusMm,
             CounterRandom& random)
{
    const Eigen::Vector3d start = placeAlong(tree.branches[parent], share);
    const Eigen::Vector3d along = (end - start).normalized();
    const Eigen::Vector3d outward = (0.5 * (start + end)).normalized();   // over the muscle instead of through it
    const Eigen::Vector3d departure = (along + 0.45 * outward).normalized();
    const Eigen::Vector3d arrival = (along - 0.45 * outward).normalized();
    const int generation = tree.branches[parent].generation + 1;
    addBranch(tree, taperedBranch(smoothPath({start, end, departure, arrival, 0.3}, random), radiusMm, 0.7),
              generation);
}

struct AorticRoot {
    Eigen::Vector3d base;
    Eigen::Vector3d up;
    VesselBranch tube;
};

AorticRoot aorticRoot(const HeartSurface& surface, CounterRandom& random)
{
    AorticRoot root;
    root.base = surface.muscle.center - 0.72 * surface.muscle.halfAxesMm.z() * surface.muscle.axes.col(2);
    root.up = Eigen::Vector3d(-0.25, -0.05, 1.0).normalized();
    root.tube = taperedBranch(smoothPath({root.base, root.base + 75.0 * root.up, root.up, root.up, 0.1}, random),
                              rootWidthMm, 13.0);
    return root;
}

VesselTree coronaries(const HeartSurface& surface, const AorticRoot& root, CounterRandom& random)
{
    const auto wallTowards = [&](const Eigen::Vector3d& place, double upMm) {
        const Eigen::Vector3d center = root.base + upMm * root.up;
        const Eigen::Vector3d way = place - center;
        const Eigen::Vector3d outward = (way - way.dot(root.up) * root.up).normalized();
        return std::pair((center + rootWidthMm * outward).eval(), outward);
    };
    VesselTree tree;
    const Eigen::Vector2d leftStart(grooveShare, 14.0);
    const auto [leftWall, leftOut] = wallTowards(surface.at(leftStart.x(), leftStart.y()), 16.0);
    addBranch(tree,
              taperedBranch(fromRoot(leftWall, leftOut,
                                     wayOver(surface, leftStart, {random.uniform(0.8, 0.95), 8.0}, random), random),
                            2.1, 0.9),
              0);
    const auto circumflex = wayOver(surface, leftStart, {grooveShare, random.uniform(125.0, 160.0)}, random);
    addBranch(tree, taperedBranch(circumflex, 1.7, 1.0), 1);
    const Eigen::Vector2d rightStart(grooveShare, -28.0);
    const auto [rightWall, rightOut] = wallTowards(surface.at(rightStart.x(), rightStart.y()), 14.0);
    addBranch(tree,
              taperedBranch(
                  fromRoot(rightWall, rightOut, wayOver(surface, rightStart, {grooveShare, -165.0}, random), random),
                  1.9, 1.2),
              0);
    addSide(tree, 0, 0.45, surface.at(0.2, 48.0), 1.2, random);   // diagonal branches
    addSide(tree, 0, 0.62, surface.at(0.55, 50.0), 1.1, random);
    addSide(tree, 1, 0.4, surface.at(0.1, 88.0), 1.2, random);   // marginal branches
    addSide(tree, 1, 0.75, surface.at(0.15, 128.0), 1.1, random);
    addSide(tree, 2, 0.5, surface.at(0.2, -85.0), 1.1, random);
    addBranch(tree, taperedBranch(wayOver(surface, {grooveShare, -165.0}, {0.6, -172.0}, random), 1.2, 0.8), 1);
    return tree;
}

void paintChambers(ScanPainter& painter, const HeartSurface& surface, const AorticRoot& root, double bloodHu,
                   double rightHu)
{
    const TurnedEllipsoid& muscle = surface.muscle;
    const Eigen::Vector3d forward = muscle.axes.col(0);
    const Eigen::Vector3d leftward = muscle.axes.col(1);
    const Eigen::Vector3d apexward = muscle.axes.col(2);
    TurnedEllipsoid fat = muscle;
    fat.halfAxesMm += Eigen::Vector3d::Constant(7.0);
    paintEllipsoid(painter, fat, epicardialFatHu);
    paintEllipsoid(painter, muscle, heartMuscleHu);
    TurnedEllipsoid left = muscle;
    left.center += 9.0 * leftward - 2.0 * forward;
    left.halfAxesMm = {18.0, 18.0, 0.78 * muscle.halfAxesMm.z()};
    TurnedEllipsoid leftWall = left;
    leftWall.halfAxesMm += Eigen::Vector3d::Constant(9.0);
    TurnedEllipsoid right = muscle;
    right.halfAxesMm -= Eigen::Vector3d::Constant(4.0);
    paintDifference(painter, right, leftWall, rightHu);
    paintEllipsoid(painter, left, bloodHu);
    const Eigen::Vector3d base = muscle.center - 1.25 * muscle.halfAxesMm.z() * apexward;
    paintEllipsoid(painter, {base - 8.0 * forward + 12.0 * leftward, muscle.axes, {17.0, 20.0, 15.0}}, bloodHu);
    paintEllipsoid(painter, {base + 2.0 * forward - 22.0 * leftward, muscle.axes, {16.0, 16.0, 15.0}}, 0.9 * rightHu);
    VesselTree pulmonary;
    const Eigen::Vector3d outflow = root.base + 12.0 * leftward + 26.0 * forward;
    addBranch(pulmonary,
              taperedBranch({outflow, outflow + 20.0 * root.up, outflow + 45.0 * root.up - 18.0 * forward}, 12.0, 12.0),
              0);
    paintTree(painter, pulmonary, painter.geometry(), 0.9 * rightHu);
}

}   // namespace

BodyScan simulateHeart(std::uint64_t seed, const BodyScanOptions& options)
{
    CounterRandom random(seed ^ 0x4EA27ULL);
    const Eigen::Vector3d extentMm(150.0, 150.0, 130.0);
    const VolumeGeometry geometry =
        gridAroundOrigin(extentMm.cwiseQuotient(options.spacingMm).array().ceil().cast<int>(), options.spacingMm);
    const ScanField field = fieldOf(geometry);
    ScanGrid grid(geometry, static_cast<float>(airHu));
    ScanPainter painter(grid);
    paintTorso(painter, field);
    for (const double side : {-1.0, 1.0}) {
        painter.ellipsoid(field.half.cwiseProduct(Eigen::Vector3d(0.62 * side, 0.0, 0.1)),
                          field.half.cwiseProduct(Eigen::Vector3d(0.42, 0.72, 1.3)), lungHu);
    }
    paintSkeleton(painter, field, random);
    const HeartSurface surface = drawSurface(random);
    const AorticRoot root = aorticRoot(surface, random);
    paintChambers(painter, surface, root, options.bloodHu, random.uniform(0.4, 0.75) * options.bloodHu);
    VesselTree aorta;
    addBranch(aorta, root.tube, 0);
    addBranch(
        aorta,
        taperedBranch({{18.0, 48.0, -1.1 * field.half.z()}, {16.0, 47.0, 0.0}, {14.0, 46.0, 1.1 * field.half.z()}},
                      11.0, 11.0),
        0);
    paintTree(painter, aorta, geometry, options.bloodHu);
    BodyScan scan;
    scan.arteries = coronaries(surface, root, random);
    paintTree(painter, scan.arteries, geometry, options.bloodHu);
    blurScan(grid, options.blurVoxels);
    scan.volume = storedVolume(grid, options.noiseHu, random.fork(1));
    scan.origins = {placeAlong(scan.arteries.branches[0], 0.08), placeAlong(scan.arteries.branches[2], 0.08)};
    return scan;
}

}   // namespace angiopose::core
