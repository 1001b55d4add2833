#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/words/spoken.h"

#include <set>

namespace angiopose::app {

/// The name of the only branch, or how many they are, in the language spoken when asked.
ui::Words branchWords(const core::VesselTree& tree, const std::set<int>& branchIds);

}   // namespace angiopose::app