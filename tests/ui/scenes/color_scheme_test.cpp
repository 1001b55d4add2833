#include "ui/scenes/branch_style.h"
#include "ui/theme/theme.h"

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <array>
#include <cmath>

namespace angiopose::ui {
namespace {

constexpr std::array schemes{ColorScheme::BlueAmber, ColorScheme::BlueRed, ColorScheme::Brightness};

/// Restores the color scheme after the test.
class ColorSchemes : public ::testing::Test {
protected:
    ~ColorSchemes() override { setColorScheme(ColorScheme::BlueAmber); }
};

double linear(double unit)
{
    return unit <= 0.04045 ? unit / 12.92 : std::pow((unit + 0.055) / 1.055, 2.4);
}

Eigen::Vector3d labFrom(const Eigen::Vector3d& linearRgb)
{
    Eigen::Matrix3d toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Eigen::Vector3d xyz = (toXyz * linearRgb).cwiseQuotient(Eigen::Vector3d(0.9505, 1.0, 1.089));
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    return {116.0 * f(xyz.y()) - 16.0, 500.0 * (f(xyz.x()) - f(xyz.y())), 200.0 * (f(xyz.y()) - f(xyz.z()))};
}

/// Normal vision, then vision without red, green or blue cones (Machado, Oliveira and Fernandes 2009, severity 1).
std::array<Eigen::Matrix3d, 4> eyes()
{
    std::array<Eigen::Matrix3d, 4> all;
    all[0].setIdentity();
    all[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
    all[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
    all[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
    return all;
}

Eigen::Vector3d seen(const Color& color, const Eigen::Matrix3d& eye)
{
    const auto unit = color.unit();
    const Eigen::Vector3d rgb(linear(unit[0]), linear(unit[1]), linear(unit[2]));
    return labFrom((eye * rgb).cwiseMax(0.0).cwiseMin(1.0));
}

TEST_F(ColorSchemes, TellResidualsApartWithAnyColorVision)
{
    for (const ColorScheme scheme : schemes) {
        setColorScheme(scheme);
        for (const Eigen::Matrix3d& eye : eyes()) {
            const Eigen::Vector3d fits = seen(residualColor(0.0), eye);
            const Eigen::Vector3d middle = seen(residualColor(0.5), eye);
            const Eigen::Vector3d end = seen(residualColor(1.0), eye);
            EXPECT_GT((fits - middle).norm(), 20.0);
            EXPECT_GT((middle - end).norm(), 20.0);
            EXPECT_GT((fits - end).norm(), 40.0);
            EXPECT_GT((seen(residualColorAboveScale(), eye) - end).norm(), 9.0);
        }
    }
}

TEST_F(ColorSchemes, TheLastNeedsNoColorAtAll)
{
    setColorScheme(ColorScheme::Brightness);
    double before = 0.0;
    for (int step = 0; step <= 10; ++step) {
        const Color color = residualColor(0.1 * step);
        EXPECT_EQ(color.red, color.green);
        EXPECT_EQ(color.green, color.blue);
        EXPECT_GT(color.red, before);
        before = color.red;
    }
    EXPECT_GT(residualColorAboveScale().red, before);
}

TEST_F(ColorSchemes, SelectedBranchesStandOutFromPlainOnes)
{
    BranchMarks marks;
    marks.selected = {1};
    for (const ColorScheme scheme : schemes) {
        setColorScheme(scheme);
        for (const ThemeMode theme : {ThemeMode::Dark, ThemeMode::Light}) {
            const BranchStyle plain = branchStyle(2, marks, palette(theme));
            const BranchStyle selected = branchStyle(1, marks, palette(theme));
            for (const Eigen::Matrix3d& eye : eyes()) {
                EXPECT_GT((seen(plain.color, eye) - seen(selected.color, eye)).norm(), 12.0);
            }
            EXPECT_GT(selected.widthFactor, plain.widthFactor);
        }
    }
}

}   // namespace
}   // namespace angiopose::ui
