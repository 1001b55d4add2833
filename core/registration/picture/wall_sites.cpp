#include "core/registration/picture/wall_sites.h"

#include "core/imaging/image_filters.h"
#include "core/registration/picture/vessel_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace angiopose::core {
namespace {

constexpr int sitesAround = 8;
constexpr double unknownSiteRadiusMm = 1.0;
constexpr double minWallCosine = 0.5;   // cosine of 60°

}   // namespace

std::vector<WallSite> wallSites(const TreeSamples& tree, std::size_t maxSites)
{
    const std::size_t rings = std::max<std::size_t>(1, maxSites / sitesAround);
    const std::size_t stride = std::max<std::size_t>(1, (tree.size() + rings - 1) / rings);
    std::vector<WallSite> sites;
    for (std::size_t i = 0; i < tree.size(); i += stride) {
        const Eigen::Vector3d side = tree.tangents[i].unitOrthogonal();
        const Eigen::Vector3d other = tree.tangents[i].cross(side);
        const double radiusMm = tree.radiusMm[i] > 0.0 ? tree.radiusMm[i] : unknownSiteRadiusMm;
        for (int k = 0; k < sitesAround; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sitesAround;
            const Eigen::Vector3d normal = std::cos(angle) * side + std::sin(angle) * other;
            sites.push_back({tree.points[i] - tree.centroid + radiusMm * normal, normal});
        }
    }
    return sites;
}

BackprojectedGradients::BackprojectedGradients(const ImageF& image, const ProjectionCamera& camera, double blurPx)
    : image_(gaussianBlur(image, blurPx)), camera_(camera)
{
}

double BackprojectedGradients::agreement(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) const
{
    const auto pixel = project(camera_, position);
    if (!pixel) {
        return 0.0;
    }
    const Eigen::Vector2d gradient = gradientAt(image_, *pixel);
    // Converts the gradient from image to camera axes; a mirrored image flips the first axis.
    const Eigen::Vector3d inDetector(std::copysign(gradient.x(), gradient.x() * camera_.fx),
                                     std::copysign(gradient.y(), gradient.y() * camera_.fy), 0.0);
    const Eigen::Vector3d ray = position.normalized();
    const Eigen::Vector3d carriedBack = inDetector - ray * ray.dot(inDetector);
    const double strength = carriedBack.norm();
    const double cosine = strength > 0.0 ? std::abs(normal.dot(carriedBack)) / strength : 0.0;
    return cosine < minWallCosine ? 0.0 : strength * cosine * cosine;
}

double BackprojectedGradients::score(const std::vector<WallSite>& sites, const CentroidPose& pose) const
{
    double sum = 0.0;
    for (const WallSite& site : sites) {
        sum += agreement(pose.rotation * site.position + pose.centroidInCamera, pose.rotation * site.normal);
    }
    return sum / static_cast<double>(sites.size());
}

}   // namespace angiopose::core
