#include "core/registration/matching/neighbor_search.h"

#include "core/registration/matching/point_cloud.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <nanoflann.hpp>

namespace angiopose::core {
namespace {

constexpr std::size_t gridLeafSize = 10;
constexpr std::size_t largestCount = 64;

class KdTreeSearch final : public NeighborSearch {
public:
    explicit KdTreeSearch(std::vector<Eigen::Vector2d> pointsPx)
        : cloud_{std::move(pointsPx)}, tree_(2, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(gridLeafSize))
    {
    }

    void find(const Eigen::Vector2d& queryPx, std::size_t count, double radiusPx,
              std::vector<Eigen::Vector2d>& foundPx) const override
    {
        assert(count <= largestCount);
        std::array<std::uint32_t, largestCount> indices{};
        std::array<double, largestCount> squaredPx{};
        const std::size_t found = tree_.knnSearch(queryPx.data(), count, indices.data(), squaredPx.data());
        foundPx.clear();
        for (std::size_t i = 0; i < found && squaredPx[i] <= radiusPx * radiusPx; ++i) {
            foundPx.push_back(cloud_.points[indices[i]]);
        }
    }

private:
    using Distance = nanoflann::L2_Simple_Adaptor<double, PointCloud>;

    PointCloud cloud_;
    nanoflann::KDTreeSingleIndexAdaptor<Distance, PointCloud, 2> tree_;
};

}   // namespace

std::unique_ptr<NeighborSearch> makeNeighborSearch(std::vector<Eigen::Vector2d> pointsPx)
{
    assert(!pointsPx.empty());
    return std::make_unique<KdTreeSearch>(std::move(pointsPx));
}

}   // namespace angiopose::core
