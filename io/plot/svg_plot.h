#pragma once

#include "core/evaluation/report/plot.h"

#include <string>

namespace angiopose::io {

/// The plot as a stand-alone SVG picture: thin grid, one colour and dash per line, bands behind, legend beside.
std::string toSvg(const core::Plot& plot);

}   // namespace angiopose::io