#pragma once

#include "core/evaluation/own/observer_agreement.h"
#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"

namespace angiopose::core {

/// How observers repeat themselves, how they lie to each other, and how each pair agrees; empty where no image was
/// read twice.
std::vector<ResultTable> observerTables(const std::vector<ObserverReading>& readings);

/// Bland–Altman plots of every pair of observers and measure that has two images in common.
std::vector<Plot> observerPlots(const std::vector<ObserverReading>& readings);

}   // namespace angiopose::core
