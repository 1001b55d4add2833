#include "ui/scenes/residual_scale.h"

#include <cmath>

namespace angiopose::ui {

int residualScaleDecimals(double maximum)
{
    const int fewest = maximum < 10.0 ? 1 : 0;
    const double half = 0.5 * maximum * (fewest == 0 ? 1.0 : 10.0);
    const bool isExact = std::abs(half - std::round(half)) < 1e-6;
    return isExact ? fewest : fewest + 1;
}

}   // namespace angiopose::ui
