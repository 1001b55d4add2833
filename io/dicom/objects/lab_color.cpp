#include "io/dicom/objects/lab_color.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace angiopose::io {
namespace {

double linear(std::uint8_t level)
{
    const double value = level / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double labCurve(double share)
{
    constexpr double knee = 216.0 / 24389.0;
    return share > knee ? std::cbrt(share) : (24389.0 / 27.0 * share + 16.0) / 116.0;
}

std::uint16_t spread(double value, double low, double high)
{
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp((value - low) / (high - low), 0.0, 1.0)));
}

}   // namespace

std::vector<std::uint16_t> labColor(const RgbColor& color)
{
    Eigen::Matrix3d xyzFromRgb;   // conversion from linear sRGB to XYZ, with the white point adapted to D50 (Bradford)
    xyzFromRgb << 0.4360747, 0.3850649, 0.1430804, 0.2225045, 0.7168786, 0.0606169, 0.0139322, 0.0971045, 0.7141733;
    const Eigen::Vector3d white = xyzFromRgb * Eigen::Vector3d::Ones();
    const Eigen::Vector3d xyz = xyzFromRgb * Eigen::Vector3d(linear(color[0]), linear(color[1]), linear(color[2]));
    const Eigen::Vector3d curved = xyz.cwiseQuotient(white).unaryExpr(&labCurve);
    const double lightness = 116.0 * curved.y() - 16.0;
    return {spread(lightness, 0.0, 100.0), spread(500.0 * (curved.x() - curved.y()), -128.0, 127.0),
            spread(200.0 * (curved.y() - curved.z()), -128.0, 127.0)};
}

}   // namespace angiopose::io
