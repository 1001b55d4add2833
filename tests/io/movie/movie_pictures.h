#pragma once

#include "core/imaging/image2d.h"
#include "tests/support/for_each.h"

#include <cmath>

namespace angiopose::io {

/// A gray background like an angiogram, with a colored line that moves.
inline core::ColorImage moviePicture(int width, int height, int step)
{
    core::ColorImage picture{width, height, {}};
    test::forEachPixel(width, height, [&](int x, int y) {
        const bool isLine = std::abs(x - y * width / height - 3 * step) < 4;
        const auto gray = static_cast<std::uint8_t>(40 + 150 * y / height + 20 * x / width);
        const std::uint8_t line[3]{40, 130, 250}, ground[3]{gray, gray, gray};
        picture.rgb.insert(picture.rgb.end(), isLine ? line : ground, (isLine ? line : ground) + 3);
    });
    return picture;
}

}   // namespace angiopose::io
