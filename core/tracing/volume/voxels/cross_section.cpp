#include "core/tracing/volume/voxels/cross_section.h"

#include "core/support/quantile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

constexpr std::size_t rayCount = 24;
constexpr double stepInVoxels = 0.25;
constexpr double maxThinRadius = 2.2;   ///< below this radius, the area follows from the integrated opacification
constexpr double brighterThanBlood = 1.6;
constexpr double maxBlood = 1.3;   ///< cap on the opacification in that integration
constexpr double blurInVoxels = 0.8;   ///< distance from the center of a thin structure to half its brightness
constexpr double minFillOfCenter = 0.15;   ///< minimum opacification at the center of a vessel

struct Ray {
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    double wallMm = 0.0;
    bool isOpen = false;   ///< no wall within reach
};

std::array<Ray, rayCount> raysAcross(const Eigen::Vector3d& tangent)
{
    Eigen::Index wallLevel = 0;
    tangent.cwiseAbs().minCoeff(&wallLevel);
    const Eigen::Vector3d u = tangent.cross(Eigen::Vector3d::Unit(wallLevel)).normalized();
    const Eigen::Vector3d v = tangent.cross(u);
    std::array<Ray, rayCount> rays;
    for (std::size_t n = 0; n < rayCount; ++n) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(n) / rayCount;
        rays[n].direction = std::cos(angle) * u + std::sin(angle) * v;
    }
    return rays;
}

/// Finds the wall, where the opacification falls below `level`. Stent struts and calcified plaque blur far beyond the
/// wall; there, the wall is taken at their brightest point, or inside their edge by the extent of the blurring.
void findWall(Ray& ray, const SectionPlane& plane, const PointOpacification& opacification, double level,
              double reachMm)
{
    const double step = stepInVoxels * plane.voxelMm;
    double previous = opacification(plane.pointMm);
    double peak = previous;
    double peakMm = 0.0;
    for (double away = step; away <= reachMm; away += step) {
        const double here = opacification(plane.pointMm + away * ray.direction);
        if (here > peak) {
            peak = here;
            peakMm = away;
        }
        const double wallLevel = peak > brighterThanBlood ? 0.5 * peak : level;
        if (here < wallLevel) {
            const double edgeMm =
                away - step * std::clamp((wallLevel - here) / std::max(previous - here, 1e-9), 0.0, 1.0);
            ray.wallMm = peak > brighterThanBlood ? std::max(peakMm, edgeMm - blurInVoxels * plane.voxelMm) : edgeMm;
            return;
        }
        previous = here;
    }
    ray.wallMm = reachMm;
    ray.isOpen = true;
}

/// Limits rays that run into a branch or an adjacent vessel to about the length of the others; returns the median.
double limitToMedian(std::array<Ray, rayCount>& rays)
{
    std::vector<double> walls;
    walls.reserve(rays.size());
    for (const Ray& ray : rays) {
        walls.push_back(ray.wallMm);
    }
    const double median = medianOf(walls);
    for (Ray& ray : rays) {
        ray.isOpen = ray.isOpen || ray.wallMm > 1.6 * median;
        ray.wallMm = std::min(ray.wallMm, 1.3 * median);
    }
    return median;
}

/// Returns the radius of the disc with the same integrated opacification as the section, without the background.
double densitometricRadius(const std::array<Ray, rayCount>& rays, const Eigen::Vector3d& center,
                           const SectionPlane& plane, const PointOpacification& opacification, double radius)
{
    const double step = stepInVoxels * plane.voxelMm;
    const double outerRadiusMm = radius + 1.5 * plane.voxelMm;
    std::vector<double> around;
    around.reserve(rays.size());
    for (const Ray& ray : rays) {
        around.push_back(opacification(center + (outerRadiusMm + 0.5 * plane.voxelMm) * ray.direction));
    }
    const double background = std::min(medianOf(around), 0.6);
    double blood = 0.0;
    for (double away = 0.5 * step; away < outerRadiusMm; away += step) {
        double ring = 0.0;
        for (const Ray& ray : rays) {
            ring += std::min(opacification(center + away * ray.direction), maxBlood) - background;
        }
        blood += ring / rayCount * 2.0 * away * step;   // area integral divided by π
    }
    return std::sqrt(std::max(0.0, blood / (1.0 - background)));
}

}   // namespace

CrossSection measureCrossSection(const SectionPlane& plane, const PointOpacification& opacification)
{
    CrossSection section{plane.pointMm, plane.expectedRadiusMm};
    const double centerFill = opacification(plane.pointMm);
    if (centerFill < minFillOfCenter) {
        return section;
    }
    std::array<Ray, rayCount> rays = raysAcross(plane.tangent);
    const double reachMm = 2.0 * plane.expectedRadiusMm + 2.0 * plane.voxelMm;
    for (Ray& ray : rays) {
        findWall(ray, plane, opacification, 0.5 * std::min(1.0, centerFill), reachMm);
    }
    section.closedFraction = 1.0 - static_cast<double>(std::ranges::count_if(rays, &Ray::isOpen)) / rayCount;
    const double median = limitToMedian(rays);
    double squares = 0.0;
    double openRays = 0.0;
    Eigen::Vector3d cubes = Eigen::Vector3d::Zero();
    for (const Ray& ray : rays) {
        squares += ray.wallMm * ray.wallMm;
        cubes += ray.wallMm * ray.wallMm * ray.wallMm * ray.direction;
        openRays += ray.isOpen ? 1.0 : 0.0;
    }
    section.centerMm += 2.0 / 3.0 * cubes / std::max(squares, 1e-12);
    section.radiusMm = std::sqrt(squares / rayCount);
    if (median < maxThinRadius * plane.voxelMm) {
        // Blurring only widens a vessel; 10 % is left for noise.
        section.radiusMm = std::min(1.1 * section.radiusMm, densitometricRadius(rays, section.centerMm, plane,
                                                                                opacification, section.radiusMm));
    }
    section.confidence = std::max(0.02, 1.0 - 3.0 * openRays / rayCount);
    return section;
}

}   // namespace angiopose::core
