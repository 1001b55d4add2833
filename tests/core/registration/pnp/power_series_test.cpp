#include "core/registration/pnp/power_series.h"

#include <gtest/gtest.h>

using namespace angiopose;

namespace {

using core::PowerSeries;

const PowerSeries line{{1.0, -1.0, 0.0, 0.0, 0.0}};   // 1 − s

TEST(PowerSeries, QuotientOfOneAndALineIsTheGeometricSeries)
{
    const PowerSeries one{{1.0}};
    const PowerSeries geometric = one / line;
    for (const double coefficient : geometric.at) {
        EXPECT_DOUBLE_EQ(coefficient, 1.0);
    }
    const PowerSeries back = geometric * line;
    EXPECT_DOUBLE_EQ(back.at[0], 1.0);
    for (std::size_t k = 1; k < PowerSeries::terms; ++k) {
        EXPECT_DOUBLE_EQ(back.at[k], 0.0) << k;
    }
}

TEST(PowerSeries, ExponentialHasTheKnownCoefficients)
{
    const PowerSeries e = exp(PowerSeries{{0.0, 2.0}});
    const std::array<double, PowerSeries::terms> known{1.0, 2.0, 2.0, 4.0 / 3.0, 2.0 / 3.0};
    for (std::size_t k = 0; k < PowerSeries::terms; ++k) {
        EXPECT_NEAR(e.at[k], known[k], 1e-15) << k;
    }
}

TEST(PowerSeries, SlopeIsThatOfTheValue)
{
    const PowerSeries series{{0.3, -1.0, 2.0, 0.5, -4.0}};
    const double h = 1e-6;
    EXPECT_NEAR(series.slope(0.4), (series.value(0.4 + h) - series.value(0.4 - h)) / (2.0 * h), 1e-8);
}

}   // namespace
