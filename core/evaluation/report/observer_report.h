#pragma once

#include "core/evaluation/own/observer_agreement.h"
#include "core/evaluation/report/plot.h"
#include "core/evaluation/report/result_table.h"

namespace angiopose::core {

/// Returns tables of the observers' repeatability, reproducibility and pairwise agreement; none if no image was reread.
std::vector<ResultTable> observerTables(const std::vector<ObserverReading>& readings);

/// Returns Bland–Altman plots for each measure and each pair of observers with at least two images in common.
std::vector<Plot> observerPlots(const std::vector<ObserverReading>& readings);

}   // namespace angiopose::core
