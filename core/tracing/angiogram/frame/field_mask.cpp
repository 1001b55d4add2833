#include "core/tracing/angiogram/frame/field_mask.h"

#include "core/imaging/gray_statistics.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/mask_morphology.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace angiopose::core {
namespace {

// Minimum slope of a shutter edge, as a fraction of the gray range per pixel. Shutter edges rise over a few pixels
// (measured 0.06), the borders of heart and diaphragm over many (0.02); all measured on the half-size image.
constexpr double sharpEdgePerPx = 0.07;
constexpr double fieldSmoothingPx = 1.0;
constexpr int edgeReachPx = 2;
constexpr double minBorderFraction = 0.6;
constexpr std::size_t drawnAreaDivisor = 200;   // the frame's area divided by the minimum area of a region
constexpr int shutterEdgePx = 4;   // width of the blurred edge, px of the full-size image

/// Finds dark regions that reach the image edge and are wider than any vessel.
Mask2d findDarkBorder(const ImageF& smooth, double threshold, int openingPx)
{
    Mask2d dark(smooth.width + 2 * openingPx, smooth.height + 2 * openingPx, 255);
    for (int y = 0; y < smooth.height; ++y) {
        for (int x = 0; x < smooth.width; ++x) {
            dark.at(x + openingPx, y + openingPx) = smooth.at(x, y) < threshold ? 255 : 0;
        }
    }
    const Mask2d wide = edgeComponents(dilate(erode(dark, openingPx), openingPx));
    Mask2d border(smooth.width, smooth.height);
    for (int y = 0; y < smooth.height; ++y) {
        for (int x = 0; x < smooth.width; ++x) {
            border.at(x, y) = wide.at(x + openingPx, y + openingPx);
        }
    }
    return border;
}

/// Returns the mean slope across the inner edge of the border, gray values per px; 0 without a border.
double edgeSlope(const ImageF& smooth, const Mask2d& border)
{
    double sum = 0.0;
    int count = 0;
    for (int y = 1; y + 1 < smooth.height; ++y) {
        for (int x = 1; x + 1 < smooth.width; ++x) {
            const bool onEdge = border.at(x, y) != 0 && (border.at(x - 1, y) == 0 || border.at(x + 1, y) == 0 ||
                                                         border.at(x, y - 1) == 0 || border.at(x, y + 1) == 0);
            if (onEdge) {
                sum += 0.5 *
                       std::hypot(smooth.at(x + 1, y) - smooth.at(x - 1, y), smooth.at(x, y + 1) - smooth.at(x, y - 1));
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 0.0;
}

/// Tries several gray levels and returns the unexposed border with the sharpest edge; empty if none is sharp enough.
Mask2d findUnexposedBorder(const ImageF& image, int openingPx)
{
    const ImageF smooth = gaussianBlur(image, fieldSmoothingPx);
    const std::vector<float> levels = grayQuantiles(smooth.pixels, {0.002, 0.5, 0.99});
    const double darkest = levels[0];
    const double middle = levels[1];
    const double range = levels[2] - darkest;
    Mask2d best(image.width, image.height);
    double bestSlope = sharpEdgePerPx * range;
    for (const double level : {0.2, 0.35, 0.5, 0.65}) {
        const Mask2d border = findDarkBorder(smooth, darkest + level * (middle - darkest), openingPx);
        const double slope = edgeSlope(smooth, border);
        if (slope > bestSlope) {
            best = border;
            bestSlope = slope;
        }
    }
    return best;
}

/// Finds regions of exactly one value at the image edge, such as digitally drawn shutters and frames.
Mask2d findDrawnBorder(const ImageF& image, std::size_t minPartPx)
{
    Mask2d flat(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float value = image.at(x, y);
            const int right = std::min(x + 1, image.width - 1);
            const int below = std::min(y + 1, image.height - 1);
            flat.at(x, y) = value == image.at(right, y) && value == image.at(x, below) &&
                                    value == image.at(std::max(0, x - 1), y) && value == image.at(x, std::max(0, y - 1))
                                ? 255
                                : 0;
        }
    }
    Mask2d drawn = edgeComponents(dilate(erode(flat, 2), 2));
    for (const std::vector<std::size_t>& part : componentsOf(drawn)) {
        if (part.size() < minPartPx) {
            for (const std::size_t p : part) {
                drawn.pixels[p] = 0;
            }
        }
    }
    return drawn;
}

ImageF negateImage(ImageF image)
{
    for (float& value : image.pixels) {
        value = -value;
    }
    return image;
}

/// Replaces the marked part of the image by the median gray value of all other pixels to suppress its contrast.
ImageF replaceByMedian(ImageF image, const Mask2d& marked)
{
    std::vector<float> unmarked;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (marked.pixels[i] == 0) {
            unmarked.push_back(image.pixels[i]);
        }
    }
    const float middle = unmarked.empty() ? 0.0F : grayQuantile(std::move(unmarked), 0.5);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = marked.pixels[i] != 0 ? middle : image.pixels[i];
    }
    return image;
}

/// Returns whether most of the image border is marked, as by a surrounding page; lungs and air mark only one side.
bool coversMostOfBorder(const Mask2d& marked)
{
    int count = 0;
    const int all = 2 * (marked.width + marked.height);
    for (int x = 0; x < marked.width; ++x) {
        count += (marked.at(x, 0) != 0 ? 1 : 0) + (marked.at(x, marked.height - 1) != 0 ? 1 : 0);
    }
    for (int y = 0; y < marked.height; ++y) {
        count += (marked.at(0, y) != 0 ? 1 : 0) + (marked.at(marked.width - 1, y) != 0 ? 1 : 0);
    }
    return count > minBorderFraction * all;
}

/// Finds the unexposed surroundings, dark or light (pages and inverted displays).
Mask2d findUnexposedArea(const ImageF& image, int openingPx)
{
    const Mask2d light = findUnexposedBorder(negateImage(image), openingPx);
    if (!coversMostOfBorder(light)) {
        return findUnexposedBorder(image, openingPx);
    }
    Mask2d both = dilate(light, edgeReachPx);
    const Mask2d dark = findUnexposedBorder(replaceByMedian(image, both), openingPx);
    for (std::size_t i = 0; i < both.pixels.size(); ++i) {
        both.pixels[i] = light.pixels[i] | dark.pixels[i];
    }
    return both;
}

Mask2d resizeMask(const Mask2d& mask, int width, int height)
{
    Mask2d result(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            result.at(x, y) = mask.at(x * mask.width / width, y * mask.height / height);
        }
    }
    return result;
}

}   // namespace

Mask2d findField(const ImageF& vesselsDark, double widestVesselPx, const Mask2d& shutter)
{
    const int openingPx = std::max(1, static_cast<int>(std::ceil(0.25 * widestVesselPx)) + 1);
    const ImageF coarse = halveSize(vesselsDark);
    const Mask2d unexposed = findUnexposedArea(coarse, openingPx);
    const Mask2d drawn = findDrawnBorder(coarse, coarse.pixels.size() / drawnAreaDivisor);
    Mask2d outside(coarse.width, coarse.height);
    for (std::size_t i = 0; i < outside.pixels.size(); ++i) {
        outside.pixels[i] = unexposed.pixels[i] | drawn.pixels[i];
    }
    outside = dilate(outside, edgeReachPx);
    Mask2d field(vesselsDark.width, vesselsDark.height);
    for (int y = 0; y < field.height; ++y) {
        for (int x = 0; x < field.width; ++x) {
            field.at(x, y) = outside.at(x / 2, y / 2) == 0 ? 255 : 0;
        }
    }
    if (!shutter.isEmpty()) {
        const Mask2d open = erode(resizeMask(shutter, field.width, field.height), shutterEdgePx);
        std::ranges::transform(field.pixels, open.pixels, field.pixels.begin(), std::bit_and<>());
    }
    return field;
}

}   // namespace angiopose::core
