#pragma once

#include "core/imaging/volume_slice.h"
#include "ui/theme/theme.h"
#include "ui/views/image_viewport.h"

#include <QImage>

#include <optional>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// Window in values of the scan (HU): black below its lower end, white above its upper end.
struct GrayWindow {
    double width = 600.0;
    double level = 200.0;

    bool operator==(const GrayWindow&) const = default;
};

/// Values and mask of one slice; `values` is empty without a scan, `mask` is empty if nothing was traced.
struct SliceContent {
    core::SliceGrid grid;
    std::vector<float> values;
    std::vector<std::uint8_t> mask;   ///< lumen, or indices of labels
};

struct MaskTint {
    Color color;
    double opacity = 0.35;

    bool operator==(const MaskTint&) const = default;
};

struct SliceTints {
    std::vector<MaskTint> mask;   ///< tints of mask values 1, 2, …; the last one applies to all higher values
    MaskTint preview;
    std::optional<double> previewFrom;   ///< threshold preview: values at or above this one are tinted
};

/// Returns the side of the slice's square image pixels in mm: the smaller of the two grid spacings.
double pixelSizeMm(const core::SliceGrid& grid);

/// Renders an interpolated slice, black outside the scan. `size` is in device px, `viewport` in device-independent px;
/// image px of the viewport are `pixelSizeMm(grid)` wide.
QImage sliceImage(const SliceContent& content, const GrayWindow& window, const SliceTints& tints,
                  const ImageViewport& viewport, const QSize& deviceSize, double devicePxPerPx);

/// Repaints the given rows (the last one excluded) after their content has changed.
void repaintSliceRows(QImage& image, std::pair<int, int> deviceRows, const SliceContent& content,
                      const GrayWindow& window, const SliceTints& tints, const ImageViewport& viewport,
                      double devicePxPerPx);

}   // namespace angiopose::ui
