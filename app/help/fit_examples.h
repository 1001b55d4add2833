#pragma once

#include "core/support/result.h"
#include "ui/dialogs/good_fit.h"

#include <QString>

namespace angiopose::app {

/// The picture of an example fit, drawn as exports are: a simulated angiogram, its vessel tree at a right or wrong
/// pose, residual colours against the true vessels. Made once per version and kept in the cache. For a worker thread.
core::Result<QString> fitExamplePicture(ui::FitExample example);

}   // namespace angiopose::app