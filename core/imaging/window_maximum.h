#pragma once

#include "core/imaging/image2d.h"

#include <algorithm>

namespace angiopose::core {

/// Combines each pixel with the pixels `step` positions to its left and right, clamped to the row. `raise(target,
/// values, count)` sets each target to the larger of target and value.
template <class T, class Raise>
Image2d<T> maximumAlongRows(const Image2d<T>& image, int step, const Raise& raise)
{
    Image2d<T> raised = image;
    const int inside = std::max(0, image.width - step);
    const int atEdge = image.width - inside;
    for (int y = 0; y < image.height; ++y) {
        if (inside > 0) {
            raise(&raised.at(atEdge, y), &image.at(0, y), inside);
            raise(&raised.at(0, y), &image.at(atEdge, y), inside);
        }
        for (int k = 0; k < atEdge; ++k) {
            raise(&raised.at(k, y), &image.at(0, y), 1);
            raise(&raised.at(inside + k, y), &image.at(image.width - 1, y), 1);
        }
    }
    return raised;
}

template <class T, class Raise>
Image2d<T> maximumAlongColumns(const Image2d<T>& image, int step, const Raise& raise)
{
    Image2d<T> raised = image;
    for (int y = 0; y < image.height; ++y) {
        raise(&raised.at(0, y), &image.at(0, std::max(0, y - step)), image.width);
        raise(&raised.at(0, y), &image.at(0, std::min(image.height - 1, y + step)), image.width);
    }
    return raised;
}

/// Computes the maximum in the square that extends `radiusPx` from each pixel in all directions, clipped to the image.
template <class T, class Raise>
Image2d<T> windowMaximum(Image2d<T> image, int radiusPx, const Raise& raise)
{
    for (int reach = 0; reach < radiusPx && !image.isEmpty();) {
        const int step = std::min(2 * reach + 1, radiusPx - reach);   // three windows at this distance leave no gap
        image = maximumAlongColumns(maximumAlongRows(image, step, raise), step, raise);
        reach += step;
    }
    return image;
}

}   // namespace angiopose::core
