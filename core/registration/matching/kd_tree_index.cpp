#include "core/registration/matching/kd_tree_index.h"

#include "core/registration/matching/point_cloud.h"

#include <cassert>
#include <cstdint>
#include <nanoflann.hpp>

namespace angiopose::core {
namespace {

constexpr std::size_t leafSize = 10;

class KdTreeIndex final : public PointIndex {
public:
    explicit KdTreeIndex(std::vector<Eigen::Vector2d> pointsPx)
        : cloud_{std::move(pointsPx)}, tree_(2, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(leafSize))
    {
    }

    std::size_t nearestIndex(const Eigen::Vector2d& queryPx) const override
    {
        std::uint32_t index = 0;
        double squaredPx = 0.0;
        tree_.knnSearch(queryPx.data(), 1, &index, &squaredPx);
        return index;
    }

    const std::vector<Eigen::Vector2d>& points() const override { return cloud_.points; }

private:
    using Distance = nanoflann::L2_Simple_Adaptor<double, PointCloud>;

    PointCloud cloud_;
    nanoflann::KDTreeSingleIndexAdaptor<Distance, PointCloud, 2> tree_;
};

}   // namespace

std::unique_ptr<PointIndex> makeKdTreeIndex(std::vector<Eigen::Vector2d> pointsPx)
{
    assert(!pointsPx.empty());
    return std::make_unique<KdTreeIndex>(std::move(pointsPx));
}

}   // namespace angiopose::core
