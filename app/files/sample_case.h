#pragma once

#include "core/support/result.h"

#include <QString>

namespace angiopose::app {

/// Generates the sample case (tree, DSA run, case file) in the application's data folder; returns the case file's path.
core::Result<QString> writeSampleCase();

}   // namespace angiopose::app
