#include "core/tracing/angiogram/frame/working_size.h"

#include "core/imaging/image_filters.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr int minSidePx = 176;
constexpr int maxSidePx = 767;
constexpr int maxDoublings = 2;   // further doubling adds no information

}   // namespace

double WorkingSize::factor() const
{
    return std::ldexp(1.0, -halvings);
}

WorkingSize chooseWorkingSize(int width, int height)
{
    const int side = std::min(width, height);
    WorkingSize size;
    while (side >> size.halvings > maxSidePx) {
        ++size.halvings;
    }
    while (size.halvings <= 0 && size.halvings > -maxDoublings && side << -size.halvings < minSidePx) {
        --size.halvings;
    }
    return size;
}

ImageF toWorkingSize(const ImageF& frame, const WorkingSize& size)
{
    ImageF image = frame;
    for (int step = 0; step < size.halvings; ++step) {
        image = halveSize(image);
    }
    const int times = 1 << std::max(0, -size.halvings);
    return times > 1 ? upsample(image, times, times * image.width, times * image.height) : image;
}

ImageF fromWorkingSize(const ImageF& image, const WorkingSize& size, int width, int height)
{
    if (size.halvings > 0) {
        return upsample(image, 1 << size.halvings, width, height);
    }
    ImageF result = image;
    for (int step = 0; step > size.halvings; --step) {
        result = halveSize(result);
    }
    return result;
}

Mask2d fromWorkingSize(const Mask2d& mask, const WorkingSize& size, int width, int height)
{
    Mask2d result(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int column = size.halvings >= 0 ? x >> size.halvings : x << -size.halvings;
            const int row = size.halvings >= 0 ? y >> size.halvings : y << -size.halvings;
            result.at(x, y) = mask.at(column, row);
        }
    }
    return result;
}

std::vector<Eigen::Vector2d> fromWorkingSize(std::vector<Eigen::Vector2d> pointsPx, const WorkingSize& size)
{
    const double factor = size.factor();
    for (Eigen::Vector2d& point : pointsPx) {
        point = (point.array() + 0.5) / factor - 0.5;   // pixel centers have integer coordinates
    }
    return pointsPx;
}

}   // namespace angiopose::core
