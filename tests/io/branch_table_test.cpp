#include "io/branch_table.h"

#include "io/support/csv_table.h"
#include "tests/support/quoted_table.h"

#include <gtest/gtest.h>
#include <limits>

using namespace angiopose;

namespace {

core::VesselTree threeBranches()
{
    core::VesselTree tree;
    core::VesselBranch measured{1, "LAD, proximal", {}, {}, 0};
    for (int i = 0; i <= 40; ++i) {
        measured.pointsInPatient.emplace_back(0.0, i, 0.0);
        measured.radiusMm.push_back(i > 18 && i < 24 ? 0.75 : 1.5);
    }
    tree.branches = {measured, {2, "", {{0, 0, 0}, {9, 0, 0}}, {}, 1}, {3, "", {{1, 1, 1}, {1, 1, 1}}, {}, 1}};
    return tree;
}

TEST(BranchTable, TellsEveryBranchAndWhatIsNotKnown)
{
    const test::QuotedTable table(io::branchTable(threeBranches()));
    const auto cell = [&](std::size_t row, const char* column) { return table.cell(row, column); };
    ASSERT_TRUE(table.isEven());
    ASSERT_EQ(table.rowCount(), 3U);
    EXPECT_EQ(cell(0, "name"), "LAD, proximal");
    EXPECT_NEAR(std::stod(cell(0, "length_mm")), 40.0, 1e-9);
    EXPECT_NEAR(std::stod(cell(0, "narrowing_percent")), 50.0, 1.0);
    EXPECT_NEAR(std::stod(cell(0, "narrowing_reference_mm")), 3.0, 0.05);
    EXPECT_NEAR(std::stod(cell(1, "length_mm")), 9.0, 1e-9);
    EXPECT_EQ(cell(1, "mean_diameter_mm"), "");
    EXPECT_NE(cell(1, "notes").find("no radii"), std::string::npos);
    EXPECT_EQ(cell(2, "length_mm"), "");
    EXPECT_NE(cell(2, "notes").find("Branch 3"), std::string::npos);
}

TEST(BranchTable, AProfileHasARowEveryHalfMillimeter)
{
    const auto profile = core::measureProfile(threeBranches().branches[0]);
    ASSERT_TRUE(profile);
    const std::string text = io::profileTable(profile.value());
    const auto table = io::parseCsv(text, "profile.csv");
    ASSERT_TRUE(table) << table.error().message;
    ASSERT_EQ(table.value().rows.size(), 81U);
    EXPECT_NEAR(io::numberInCell(table.value(), 41, *table.value().column("y")).value(), 20.5, 1e-9);
    EXPECT_NEAR(io::numberInCell(table.value(), 41, *table.value().column("diameter_mm")).value(), 1.5, 1e-9);
}

}   // namespace
