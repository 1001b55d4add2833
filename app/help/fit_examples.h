#pragma once

#include "core/support/result.h"
#include "ui/dialogs/good_fit.h"

#include <QString>

namespace angiopose::app {

/// Returns the image of an example fit, drawn like an export: a simulated angiogram, its vessel tree at a correct or
/// wrong pose, and residual colors relative to the true vessels. The image is created once per program version and
/// cached. Call it on a worker thread.
core::Result<QString> fitExampleImage(ui::FitExample example);

}   // namespace angiopose::app
