#pragma once

#include "core/measuring/image_scale.h"
#include "core/support/message.h"
#include "ui/scenes/image_mark.h"

#include <functional>
#include <string>
#include <vector>

namespace angiopose::app {

/// What is drawn on a frame of a view: its measurements with their values. `toText` says a message.
std::vector<ui::ImageMark> marksOf(const core::MeasuredView& seen, int frame,
                                   const std::function<std::string(const core::Message&)>& toText);

}   // namespace angiopose::app
