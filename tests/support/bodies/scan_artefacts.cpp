#include "tests/support/bodies/scan_artefacts.h"

#include <numbers>

namespace angiopose::core {
namespace {

constexpr double maxStoredMagnitude = 32000.0;

template <class Work>
void eachPlace(ScanGrid& grid, const Work& work)
{
    std::size_t voxel = 0;
    const VolumeGeometry& geometry = grid.geometry;
    for (int k = 0; k < geometry.size.z(); ++k) {
        for (int j = 0; j < geometry.size.y(); ++j) {
            for (int i = 0; i < geometry.size.x(); ++i, ++voxel) {
                work(grid.voxels[voxel],
                     geometry.originInPatient + geometry.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k)));
            }
        }
    }
}

Eigen::Vector3d halfOf(const VolumeGeometry& geometry)
{
    return 0.5 * geometry.spacingMm.cwiseProduct((geometry.size.array() - 1).cast<double>().matrix());
}

}   // namespace

void applyFallOff(ScanGrid& grid, const CoilFallOff& coil)
{
    const double farMm = halfOf(grid.geometry).maxCoeff();
    eachPlace(grid, [&](float& value, const Eigen::Vector3d& place) {
        const double away = (place - coil.strongestAt).norm() / farMm;
        value /=
            static_cast<float>(1.0 + (coil.strength - 1.0) * away * away);   // not a Gaussian, which the tracing fits
    });
}

Volume asMagnitudes(const ScanGrid& grid, double noise, const CounterRandom& random)
{
    return roundVolume(grid, random, [noise](double signal, CounterRandom& sliceRandom) {
        const double real = signal + noise * sliceRandom.normal();
        return std::min(std::hypot(real, noise * sliceRandom.normal()), maxStoredMagnitude);
    });
}

void addConeBeamArtefacts(ScanGrid& grid, double strength, CounterRandom& random)
{
    const Eigen::Vector3d half = halfOf(grid.geometry);
    const Eigen::Vector3d center = grid.geometry.originInPatient + half;
    const double radius = std::min(half.x(), half.y());
    const double turn = random.uniform(0.0, std::numbers::pi);
    const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
    eachPlace(grid, [&](float& value, const Eigen::Vector3d& place) {
        const Eigen::Vector3d at = (place - center) / radius;
        const double across = std::cos(turn) * at.x() + std::sin(turn) * at.y();
        const double fromMiddle = std::hypot(at.x(), at.y());
        if (fromMiddle > 1.0) {
            value = 0.0F;
            return;
        }
        const double shading = 0.5 * across + 0.4 * at.z() * at.z();
        const double streaks = 0.35 * std::sin(18.0 * across + phase) * std::exp(-4.0 * fromMiddle * fromMiddle);
        const double edge = 0.8 * std::pow(fromMiddle, 8);
        value += static_cast<float>(strength * (shading + streaks + edge));
    });
}

}   // namespace angiopose::core
