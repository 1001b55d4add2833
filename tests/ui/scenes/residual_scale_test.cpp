#include "ui/scenes/residual_scale.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

TEST(ResidualScale, TellsTheHalfOfARoundEndExactly)
{
    EXPECT_EQ(ui::residualScaleDecimals(2.0), 1) << "2.0 and 1.0";
    EXPECT_EQ(ui::residualScaleDecimals(5.0), 1) << "5.0 and 2.5";
    EXPECT_EQ(ui::residualScaleDecimals(0.5), 2) << "0.50 and 0.25";
    EXPECT_EQ(ui::residualScaleDecimals(20.0), 0) << "20 and 10";
    EXPECT_EQ(ui::residualScaleDecimals(15.0), 1) << "15.0 and 7.5";
}

TEST(ResidualScale, IsBriefWhereTheHalfHasNoEnd)
{
    EXPECT_EQ(ui::residualScaleDecimals(8.3712), 2);
    EXPECT_EQ(ui::residualScaleDecimals(23.417), 1);
}

}   // namespace
