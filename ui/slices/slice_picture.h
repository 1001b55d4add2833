#pragma once

#include "core/imaging/volume_slice.h"
#include "ui/theme/theme.h"
#include "ui/views/image_viewport.h"

#include <QImage>

#include <optional>
#include <utility>
#include <vector>

namespace angiopose::ui {

/// Gray window in the scan's values (HU): black below its lower end, white above its upper end.
struct GrayWindow {
    double width = 600.0;
    double level = 200.0;

    bool operator==(const GrayWindow&) const = default;
};

/// Content of a slice; values are empty without a scan, the mask is empty if nothing was traced.
struct SliceContent {
    core::SliceGrid grid;
    std::vector<float> values;
    std::vector<std::uint8_t> mask;   ///< lumen, or label index
};

struct MaskTint {
    Color color;
    double opacity = 0.35;

    bool operator==(const MaskTint&) const = default;
};

struct SliceTints {
    std::vector<MaskTint> mask;   ///< for mask values 1, 2, …; the last applies to all higher values
    MaskTint preview;
    std::optional<double> previewFrom;   ///< tints values at or above this one
};

/// Pixel size of a slice on the screen, the same in both directions: mm of the finer one.
double unitMmOf(const core::SliceGrid& grid);

/// Renders the slice, interpolated, through a viewport whose image px are `unitMmOf(grid)` wide; `size` in device px,
/// `viewport` in device-independent px. Black outside the scan.
QImage slicePicture(const SliceContent& content, const GrayWindow& window, const SliceTints& tints,
                    const ImageViewport& viewport, const QSize& deviceSize, double devicePxPerPx);

/// Repaints the given rows (last one excluded) after the content changed there.
void repaintSliceRows(QImage& picture, std::pair<int, int> deviceRows, const SliceContent& content,
                      const GrayWindow& window, const SliceTints& tints, const ImageViewport& viewport,
                      double devicePxPerPx);

}   // namespace angiopose::ui