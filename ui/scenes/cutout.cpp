#include "ui/scenes/cutout.h"

#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

struct CutoutSpan {
    int from = 0;
    int to = 0;
};

/// Returns the range of columns in row `y` that lies inside the cutout.
CutoutSpan spanOf(const Cutout& cutout, const Eigen::Vector2d& center, double radius, int y, int width)
{
    const auto column = [width](double x) { return static_cast<int>(std::clamp(std::round(x), 0.0, 1.0 * width)); };
    if (cutout.shape == Cutout::Shape::RightOf) {
        return {column(center.x()), width};
    }
    const double height = y + 0.5 - center.y();
    const double half2 = radius * radius - height * height;
    if (half2 <= 0.0) {
        return {};
    }
    return {column(center.x() - std::sqrt(half2)), column(center.x() + std::sqrt(half2))};
}

}   // namespace

void applyCutout(const Cutout& cutout, const ViewRect& rect, const std::vector<std::uint32_t>& background,
                 Canvas canvas, const Rows& rows)
{
    if (cutout.shape == Cutout::Shape::None) {
        return;
    }
    const double scale = canvas.width / rect.width();
    const Eigen::Vector2d center((cutout.at.x() - rect.left) * scale,
                                 (cutout.at.y() - rect.top) * canvas.height / rect.height());
    const std::uint32_t edge = packColor(palette(ThemeMode::Dark).label);
    for (int y = rows.from; y < rows.to; ++y) {
        const CutoutSpan span = spanOf(cutout, center, cutout.radiusPx * scale, y, canvas.width);
        if (span.from >= span.to) {
            continue;
        }
        const std::uint32_t* source = background.data() + static_cast<std::ptrdiff_t>(y) * canvas.width;
        std::copy(source + span.from, source + span.to, canvas.row(y) + span.from);
        canvas.row(y)[span.from] = edge;
        if (cutout.shape == Cutout::Shape::Disc) {
            canvas.row(y)[span.to - 1] = edge;
        }
    }
}

}   // namespace angiopose::ui
