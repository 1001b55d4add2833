#pragma once

#include "core/imaging/display_range.h"
#include "core/imaging/image2d.h"
#include "ui/scenes/revision.h"

#include <cstdint>

namespace angiopose::ui {

/// Frame mapped to 8-bit gray values by window and level; computed on demand.
class GrayFrame {
public:
    void setPixels(const core::ImageF& pixels);
    void setRange(const core::DisplayRange& range);
    void setInverted(bool inverted);
    bool isInverted() const { return isInverted_; }

    const core::ImageF& pixels() const { return pixels_; }
    int width() const { return pixels_.width; }
    int height() const { return pixels_.height; }
    std::uint64_t revision() const { return revision_; }   ///< changes whenever a setter changes the gray values
    const core::Image2d<std::uint8_t>& gray() const;

private:
    core::ImageF pixels_;
    core::DisplayRange range_;
    bool isInverted_ = false;
    std::uint64_t revision_ = nextRevision();
    mutable std::uint64_t grayRevision_ = 0;
    mutable core::Image2d<std::uint8_t> gray_;
};

}   // namespace angiopose::ui
