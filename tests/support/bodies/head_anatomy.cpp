#include "tests/support/bodies/head_anatomy.h"

#include "core/simulation/smooth_path.h"
#include "tests/support/bodies/body_shapes.h"

namespace angiopose::core {
namespace {

/// Mirrors a point to one side; +1 is left.
Eigen::Vector3d onSide(double side, double across, double back, double up)
{
    return {side * across, back, up};
}

VesselBranch vesselAlong(const PathPlan& plan, double firstRadiusMm, double lastRadiusMm, CounterRandom& random)
{
    return taperedBranch(smoothPath(plan, random), firstRadiusMm, lastRadiusMm);
}

/// Adds the arteries of one side from the neck to the cerebral arteries.
void addCarotid(VesselTree& tree, double side, CounterRandom& random)
{
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    const Eigen::Vector3d neck = onSide(side, 28.0, 2.0, -82.0);
    const Eigen::Vector3d petrous = onSide(side, 26.0, 0.0, -48.0);
    const Eigen::Vector3d siphon = onSide(side, 12.0, -14.0, -34.0);
    const Eigen::Vector3d terminus = onSide(side, 11.0, -6.0, -24.0);
    const Eigen::Vector3d inward = onSide(side, -0.8, -0.6, 0.15).normalized();
    std::vector<Eigen::Vector3d> way = smoothPath({neck, petrous, up, up, 0.5}, random);
    for (const PathPlan& plan : {PathPlan{petrous, siphon, up, inward, 0.2},
                                 PathPlan{siphon, terminus, inward, onSide(side, 0.1, 0.7, 0.7).normalized(), 0.2}}) {
        const auto more = smoothPath(plan, random);
        way.insert(way.end(), more.begin() + 1, more.end());
    }
    addBranch(tree, taperedBranch(way, 2.3, 1.9), 0);
    const Eigen::Vector3d outward = onSide(side, 1.0, 0.0, 0.1).normalized();
    const Eigen::Vector3d sylvian = onSide(side, 40.0, 2.0, -16.0);
    addBranch(tree, vesselAlong({terminus, sylvian, outward, outward, 0.6}, 1.5, 1.2, random), 1);
    for (const double lift : {0.25, 0.8}) {   // over the insula
        addBranch(tree,
                  vesselAlong({sylvian, onSide(side, 50.0, 25.0 - 50.0 * lift, 30.0 * lift), outward,
                               onSide(side, 0.2, 0.4, 1.0).normalized(), 1.2},
                              1.1, 0.7, random),
                  2);
    }
    const Eigen::Vector3d middle = onSide(side, 2.5, -16.0, -22.0);
    addBranch(tree,
              vesselAlong({terminus, middle, onSide(side, -0.8, -0.6, 0.1).normalized(),
                           onSide(side, -0.3, -0.9, 0.2).normalized(), 0.3},
                          1.2, 1.1, random),
              1);
    addBranch(
        tree,
        vesselAlong({middle, onSide(side, 2.5, -10.0, 38.0), {0.0, -0.8, 0.6}, {0.0, 0.9, 0.4}, 0.8}, 1.1, 0.7, random),
        2);
    addBranch(tree,
              vesselAlong({terminus, onSide(side, 8.0, 12.0, -26.0), {0.0, 0.9, -0.2}, {0.0, 1.0, 0.0}, 0.3}, 0.7, 0.65,
                          random),
              1);   // posterior communicating artery
}

/// Adds the vertebral arteries, the basilar artery and the posterior cerebral arteries that meet the communicating
/// ones.
void addPosterior(VesselTree& tree, CounterRandom& random)
{
    const Eigen::Vector3d up(0.0, 0.0, 1.0);
    const Eigen::Vector3d join(0.0, 16.0, -50.0);
    const Eigen::Vector3d top(0.0, 9.0, -27.0);
    addBranch(tree, vesselAlong({join, top, up, up, 0.4}, 1.7, 1.5, random), 0);
    for (const double side : {-1.0, 1.0}) {
        addBranch(tree,
                  vesselAlong({onSide(side, 12.0, 30.0, -82.0), join, up, onSide(-side, 0.7, -0.4, 0.6), 0.4}, 1.5, 1.3,
                              random),
                  0);
        const Eigen::Vector3d meeting = onSide(side, 8.0, 12.0, -26.0);
        addBranch(tree,
                  vesselAlong({top, meeting, onSide(side, 1.0, 0.0, 0.1).normalized(),
                               onSide(side, 0.6, 0.8, 0.0).normalized(), 0.2},
                              1.1, 1.0, random),
                  1);
        addBranch(tree,
                  vesselAlong({meeting, onSide(side, 12.0, 58.0, -8.0), onSide(side, 0.7, 0.7, 0.0).normalized(),
                               onSide(-side, 0.3, 1.0, 0.2).normalized(), 0.8},
                              1.0, 0.7, random),
                  2);
    }
}

void paintSkull(ScanPainter& painter, const HeadValues& values)
{
    TurnedEllipsoid outer{{0.0, 8.0, 2.0}, Eigen::Matrix3d::Identity(), {74.0, 90.0, 78.0}};
    TurnedEllipsoid inner = outer;
    inner.halfAxesMm -= Eigen::Vector3d::Constant(6.0);
    paintEllipsoid(painter, outer, values.skull);
    paintEllipsoid(painter, inner, values.brain);
    for (const double side : {-1.0, 1.0}) {   // around the carotid canal
        paintEllipsoid(painter, {onSide(side, 32.0, 8.0, -46.0), Eigen::Matrix3d::Identity(), {20.0, 13.0, 12.0}},
                       values.petrous);
    }
    paintEllipsoid(painter, {{0.0, 4.0, -46.0}, Eigen::Matrix3d::Identity(), {10.0, 9.0, 14.0}}, values.clivus);
    painter.ellipsoid({0.0, 42.0, -90.0}, {22.0, 18.0, 34.0}, values.skull);   // cervical spine
    painter.ellipsoid({0.0, 42.0, -90.0}, {19.0, 15.0, 34.0}, values.marrow);
}

}   // namespace

VesselTree headArteries(CounterRandom& random)
{
    VesselTree arteries;
    for (const double side : {-1.0, 1.0}) {
        addCarotid(arteries, side, random);
    }
    addBranch(
        arteries,
        taperedBranch({onSide(-1.0, 2.5, -16.0, -22.0), {0.0, -16.5, -22.0}, onSide(1.0, 2.5, -16.0, -22.0)}, 0.9, 0.9),
        2);
    addPosterior(arteries, random);
    return arteries;
}

VesselTree headSinuses(CounterRandom& random)
{
    VesselTree tree;
    addBranch(
        tree,
        vesselAlong({{0.0, -66.0, 20.0}, {0.0, 84.0, 10.0}, {0.0, -0.2, 1.0}, {0.0, 0.3, -1.0}, 0.0}, 2.5, 4.5, random),
        0);
    for (const double side : {-1.0, 1.0}) {
        addBranch(tree,
                  vesselAlong({{0.0, 84.0, 10.0},
                               onSide(side, 50.0, 30.0, -40.0),
                               onSide(side, 1.0, 0.1, -0.2).normalized(),
                               onSide(side, 0.2, -0.5, -0.8).normalized(),
                               0.2},
                              4.0, 4.0, random),
                  1);
    }
    return tree;
}

void paintHead(ScanPainter& painter, const HeadValues& values)
{
    painter.ellipsoid({0.0, 8.0, 2.0}, {80.0, 96.0, 84.0}, values.scalp);
    painter.ellipsoid({0.0, 20.0, -90.0}, {58.0, 62.0, 60.0}, values.scalp);   // neck
    paintSkull(painter, values);
}

}   // namespace angiopose::core
