#pragma once

namespace angiopose::ui {

/// Returns the number of decimals for the labels at the end and the middle of the residual scale: the fewest decimals
/// that show half of a round maximum exactly, but at least one if the maximum is below 10.
int residualScaleDecimals(double maximum);

}   // namespace angiopose::ui
