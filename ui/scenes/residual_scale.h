#pragma once

namespace angiopose::ui {

/// Digits behind the decimal sign of the numbers at the residual scale, its end and its half alike: as few as tell the
/// half of a round end exactly, but one at least below 10.
int residualScaleDecimals(double maximum);

}   // namespace angiopose::ui