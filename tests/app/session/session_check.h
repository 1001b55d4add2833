#pragma once

#include "app/case_controller.h"

namespace angiopose::test {

/// Saves the open case, opens the file in a second window, saves again and compares the two files byte for byte. Empty
/// when they are equal, otherwise describes the difference.
QString differenceAfterReopening(app::CaseController& controller, const QString& folder);

}   // namespace angiopose::test
