#include "core/simulation/paint_torso.h"

#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double marrowHu = 170.0;
constexpr double trabeculaeHu = 90.0;   ///< standard deviation within the bone marrow

}   // namespace

ScanField fieldOf(const VolumeGeometry& geometry)
{
    const Eigen::Vector3d half = 0.5 * geometry.spacingMm.cwiseProduct(geometry.size.cast<double>());
    return {geometry.originInPatient + half - 0.5 * geometry.spacingMm, half};
}

void paintTorso(ScanPainter& painter, const ScanField& field)
{
    const double infinite = std::numeric_limits<double>::infinity();
    painter.ellipsoid(field.center, {0.97 * field.half.x(), 0.93 * field.half.y(), infinite}, fatHu);
    painter.ellipsoid(field.center, {0.9 * field.half.x(), 0.86 * field.half.y(), infinite}, muscleHu);
}

void paintSkeleton(ScanPainter& painter, const ScanField& field, CounterRandom& random)
{
    const auto marrow = [&] { return marrowHu + trabeculaeHu * random.normal(); };
    const double depth = 0.72 * field.half.y();
    constexpr double vertebraMm = 30.0;
    for (double z = -field.half.z(); z < field.half.z() + vertebraMm; z += vertebraMm) {
        const Eigen::Vector3d vertebra = field.center + Eigen::Vector3d(0.0, depth, z);
        painter.ellipsoid(vertebra, {17.0, 14.0, 16.0}, cortexHu);
        painter.ellipsoid(vertebra, {15.4, 12.4, 14.4}, marrow);
        for (const double side : {-1.0, 1.0}) {
            const auto bead = [&](int number) {
                const double angle = side * (0.5 + 0.03 * number);
                return (field.center + Eigen::Vector3d(0.88 * field.half.x() * std::sin(angle),
                                                       0.8 * field.half.y() * std::cos(angle), z - 0.4 * number))
                    .eval();
            };
            for (int number = 0; number < 60; ++number) {
                painter.ellipsoid(bead(number), Eigen::Vector3d::Constant(4.5), cortexHu);
            }
            for (int number = 0; number < 60; ++number) {
                painter.ellipsoid(bead(number), Eigen::Vector3d::Constant(3.2), marrow);
            }
        }
    }
}

}   // namespace angiopose::core
