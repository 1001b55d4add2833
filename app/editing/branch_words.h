#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/words/retranslation.h"

#include <set>

namespace angiopose::app {

/// Returns the name of a single branch or the number of branches, in the UI language at the time of use.
ui::LocalizedText branchNames(const core::VesselTree& tree, const std::set<int>& branchIds);

}   // namespace angiopose::app
