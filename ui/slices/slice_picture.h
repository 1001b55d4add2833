#pragma once

#include "core/imaging/volume_slice.h"
#include "ui/theme/theme.h"
#include "ui/views/image_viewport.h"

#include <QImage>

#include <optional>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// Which values of a scan are grey: below the lower end black, above the upper white. In the scan's values (HU).
struct GrayWindow {
    double width = 600.0;
    double level = 200.0;

    bool operator==(const GrayWindow&) const = default;
};

/// What a slice holds; values and mask are empty where there is no scan or nothing was traced.
struct SliceContent {
    core::SliceGrid grid;
    std::vector<float> values;
    std::vector<std::uint8_t> mask;   ///< the lumen, or which label
};

struct MaskTint {
    Color color;
    double opacity = 0.35;

    bool operator==(const MaskTint&) const = default;
};

struct SliceTints {
    std::vector<MaskTint> mask;   ///< of mask value 1, 2, …; the last of all values from there on
    MaskTint preview;
    std::optional<double> previewFrom;   ///< tints what is not below this value
};

/// Pixel size of a slice on the screen: both directions in the same unit, mm of the finer one.
double unitMmOf(const core::SliceGrid& grid);

/// The slice as seen through a viewport whose image px are `unitMmOf(grid)` wide, interpolated; `size` in device px,
/// `viewport` in device-independent ones. Black outside the scan.
QImage slicePicture(const SliceContent& content, const GrayWindow& window, const SliceTints& tints,
                    const ImageViewport& viewport, const QSize& deviceSize, double devicePxPerPx);

/// Paints some of its rows once more, the last one left out: the content changed there alone.
void repaintSliceRows(QImage& picture, std::pair<int, int> deviceRows, const SliceContent& content,
                      const GrayWindow& window, const SliceTints& tints, const ImageViewport& viewport,
                      double devicePxPerPx);

}   // namespace angiopose::ui