#include "ui/scenes/gray_frame.h"

#include <utility>

namespace angiopose::ui {

void GrayFrame::setPixels(const core::ImageF& pixels)
{
    pixels_ = pixels;
    revision_ = nextRevision();
}

void GrayFrame::setRange(const core::DisplayRange& range)
{
    if (range.low != range_.low || range.high != range_.high) {
        range_ = range;
        revision_ = nextRevision();
    }
}

void GrayFrame::setInverted(bool inverted)
{
    if (inverted != isInverted_) {
        isInverted_ = inverted;
        revision_ = nextRevision();
    }
}

const core::Image2d<std::uint8_t>& GrayFrame::gray() const
{
    if (std::exchange(grayRevision_, revision_) == revision_) {
        return gray_;
    }
    gray_.width = pixels_.width;
    gray_.height = pixels_.height;
    gray_.pixels.resize(pixels_.pixels.size());
    const double span = range_.window();
    const auto gain = static_cast<float>(span > 0.0 ? 255.0 / span : 1e30);
    const auto low = static_cast<float>(range_.low);
    const float sign = isInverted_ ? -1.0F : 1.0F;
    const float base = isInverted_ ? 255.5F : 0.5F;
    for (std::size_t i = 0; i < pixels_.pixels.size(); ++i) {
        const float value = (pixels_.pixels[i] - low) * gain;
        const float bounded = value > 0.0F ? (value < 255.0F ? value : 255.0F) : 0.0F;   // maps NaN to 0
        gray_.pixels[i] = static_cast<std::uint8_t>(base + sign * bounded);
    }
    return gray_;
}

}   // namespace angiopose::ui
