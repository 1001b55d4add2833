#include "io/vessel_tree_file.h"

#include "tests/support/test_data.h"

#include <gtest/gtest.h>

using namespace angiopose;

TEST(ReadVesselTree, ReadsThePhantomTree)
{
    ANGIOPOSE_NEEDS_DATA("coronary-phantom-xa/tree/Centerlines.vtk");
    const auto tree = io::readVesselTree(test::dataFile("coronary-phantom-xa/tree/Centerlines.vtk").string());
    ASSERT_TRUE(tree) << tree.error().message;
    ASSERT_EQ(tree.value().branches.size(), 11u);
    EXPECT_EQ(tree.value().pointCount(), 453u);   // the lines visit 453 of the 464 points in the file
    double length = 0.0;
    for (const auto& branch : tree.value().branches) {
        length += branch.lengthMm();
    }
    EXPECT_NEAR(length, 785.0, 1.0);
    EXPECT_EQ(tree.value().branches[3].pointsInPatient.size(), 52u);
    EXPECT_EQ(tree.value().branches[10].id, 11);
}
