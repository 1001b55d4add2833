#include "core/imaging/fill_surface.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

/// A tube along z, open or closed at its ends.
SurfaceMesh tubeMesh(double radius, double length, bool isClosed)
{
    SurfaceMesh mesh;
    constexpr std::uint32_t sides = 48;
    for (const double z : {0.0, length}) {
        for (std::uint32_t k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            mesh.pointsInPatient.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    }
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t next = (k + 1) % sides;
        mesh.triangles.push_back({k, next, sides + next});
        mesh.triangles.push_back({k, sides + next, sides + k});
        if (isClosed && k > 0 && k + 1 < sides) {
            mesh.triangles.push_back({0, next, k});
            mesh.triangles.push_back({sides, sides + k, sides + next});
        }
    }
    return mesh;
}

double insideMm3(const VoxelMask& mask)
{
    const auto count = std::count_if(mask.voxels.begin(), mask.voxels.end(), [](auto voxel) { return voxel != 0; });
    return static_cast<double>(count) * mask.geometry.spacingMm.prod();
}

}   // namespace

TEST(FillSurface, HoldsTheVolumeOfTheTube)
{
    const double polygonArea = 0.5 * 48 * 25.0 * std::sin(2.0 * std::numbers::pi / 48);
    for (const bool isClosed : {true, false}) {   // the other axes close the open ends of a vessel
        const SurfaceMesh mesh = tubeMesh(5.0, 40.0, isClosed);
        EXPECT_EQ(checkMesh(mesh).isClosed(), isClosed);
        const auto mask = fillSurface(mesh, 0.23);   // the radius is not a multiple of it
        ASSERT_TRUE(mask) << mask.error().message;
        EXPECT_NEAR(insideMm3(mask.value()), polygonArea * 40.0, 0.02 * polygonArea * 40.0);
    }
}

TEST(FillSurface, OverlappingTubesAreOneInside)
{
    SurfaceMesh both = tubeMesh(5.0, 40.0, true);
    const SurfaceMesh second = tubeMesh(3.0, 40.0, true);   // inside the first
    const auto offset = static_cast<std::uint32_t>(both.pointsInPatient.size());
    both.pointsInPatient.insert(both.pointsInPatient.end(), second.pointsInPatient.begin(),
                                second.pointsInPatient.end());
    for (const auto& t : second.triangles) {
        both.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
    const auto alone = fillSurface(tubeMesh(5.0, 40.0, true), 0.5);
    const auto joined = fillSurface(both, 0.5);
    ASSERT_TRUE(alone && joined);
    EXPECT_EQ(joined.value().voxels, alone.value().voxels);
}

TEST(FillSurface, UsualVoxelsAreCoarserForWhatIsSolid)
{
    const double slim = defaultSpacingMm(tubeMesh(1.0, 400.0, true));
    const double solid = defaultSpacingMm(tubeMesh(60.0, 120.0, true));
    EXPECT_NEAR(slim, 0.1, 1e-12) << "as fine as can be";
    const double inside = std::numbers::pi * 60.0 * 60.0 * 120.0;
    EXPECT_NEAR(inside / std::pow(solid, 3), 5e6, 1e5) << "voxels to be thinned";
    EXPECT_EQ(defaultSpacingMm(SurfaceMesh{}), 1.0);
}

TEST(FillSurface, EndsWhenStopped)
{
    for (const int heardAfter : {1, 2, 5, 50}) {
        int asked = 0;
        const auto mask = fillSurface(tubeMesh(5.0, 40.0, false), 0.2, [&] { return ++asked < heardAfter; });
        ASSERT_FALSE(mask);
        EXPECT_TRUE(mask.isStopped());
        EXPECT_EQ(asked, heardAfter) << "once stopped, it is not asked again";
    }
    EXPECT_TRUE(fillSurface(tubeMesh(5.0, 40.0, false), 0.2, [] { return true; }));
}

TEST(FillSurface, RefusesWhatBoundsNothing)
{
    EXPECT_FALSE(fillSurface({}, 1.0));
    SurfaceMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    EXPECT_FALSE(fillSurface(flat, 0.1));
    EXPECT_FALSE(fillSurface(tubeMesh(5.0, 40.0, true), 0.0001));
    SurfaceMesh sheet{{{0, 0, 0}, {9, 0, 4}, {0, 9, 2}}, {{0, 1, 2}}};
    EXPECT_FALSE(fillSurface(sheet, 0.5)) << "a single triangle";
}

TEST(CheckMesh, FindsHolesAndTurnedTriangles)
{
    SurfaceMesh mesh = tubeMesh(5.0, 40.0, true);
    EXPECT_TRUE(checkMesh(mesh).isOriented);
    std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
    EXPECT_FALSE(checkMesh(mesh).isOriented);
    mesh.triangles.pop_back();
    EXPECT_EQ(checkMesh(mesh).boundaryEdges, 3U);
}

}   // namespace angiopose::core
