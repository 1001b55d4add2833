#pragma once

#include "app/case_controller.h"

namespace angiopose::test {

/// Saves the open case, opens the file in a second window, saves again and compares the two files byte by byte.
/// Empty when they are equal, else what differs.
QString differenceAfterReopening(app::CaseController& controller, const QString& folder);

}   // namespace angiopose::test