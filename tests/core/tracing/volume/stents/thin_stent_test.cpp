#include "core/tracing/volume/stents/thin_stent.h"

#include "tests/support/drawn_tubes.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using test::Tube;

/// A scan of 40 x 30 x 80 mm in 1 mm voxels, with a bright tube from z = -12 to 12 and blood in other tubes.
class ThinStent : public testing::Test {
protected:
    static bool isStent(const Tube& metalTube, const std::vector<Tube>& vessels)
    {
        const core::VolumeGeometry grid = test::gridAround({0, 0, 0}, {40, 30, 80}, {1.0, 1.0, 1.0});
        const core::VoxelMask metal = test::drawnMask(grid, {metalTube});
        const core::VoxelMask blood = test::drawnMask(grid, vessels);
        core::VoxelComponent piece;
        for (std::uint32_t voxel = 0; voxel < metal.voxels.size(); ++voxel) {
            if (metal.voxels[voxel] != 0) {
                piece.push_back(voxel);
            }
        }
        return core::isThinStent(piece, grid, [&](int i, int j, int k) {
            return metal.at(i, j, k) != 0 ? 8.0 : blood.at(i, j, k) != 0 ? 1.0 : 0.0;
        });
    }

    const Tube wires_{{0, 0, -12}, {0, 0, 12}, 3.0};
    const Tube before_{{0, 0, -38}, {0, 0, -12}, 2.2};
    const Tube behind_{{0, 0, 12}, {0, 0, 38}, 2.2};
};

TEST_F(ThinStent, HasAVesselBeyondBothItsEnds)
{
    EXPECT_TRUE(isStent(wires_, {before_, behind_}));
}

TEST_F(ThinStent, TheVesselMayDeformationBehindIt)
{
    EXPECT_TRUE(isStent(wires_, {before_, {{0, 0, 12}, {12, 0, 26}, 2.2}}));
}

TEST_F(ThinStent, WiresThatOneVesselTouchesAreNone)
{
    EXPECT_FALSE(isStent(wires_, {before_}));
    EXPECT_FALSE(isStent(wires_, {}));
    EXPECT_FALSE(isStent(wires_, {{{6, 0, -38}, {6, 0, 0}, 2.2}}));
}

TEST_F(ThinStent, ClipsAndThickPiecesAreNone)
{
    EXPECT_FALSE(isStent({{0, 0, -1}, {0, 0, 1}, 4.0}, {{{0, 0, -38}, {0, 0, 38}, 2.2}}));
    EXPECT_FALSE(isStent({{0, 0, -25}, {0, 0, 25}, 9.0}, {{{0, 0, -38}, {0, 0, 38}, 2.2}}));
}

}   // namespace
