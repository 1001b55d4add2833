#pragma once

namespace angiopose::ui {

/// Visible part of the image in pixel coordinates (pixel centers at integers, y down).
struct ViewRect {
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool operator==(const ViewRect&) const = default;
};

}   // namespace angiopose::ui
