#pragma once

namespace angiopose::ui {

/// Returns the decimals of the residual scale's labels, used for both its end and its half: the fewest that show half
/// of a round end exactly, but at least one below 10.
int residualScaleDecimals(double maximum);

}   // namespace angiopose::ui