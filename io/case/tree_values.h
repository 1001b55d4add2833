#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"

#include <string>
#include <string_view>

namespace angiopose::io {

/// A vessel tree as the JSON that a case keeps under `vessel.editedTree`, exact to the last bit.
std::string treeJson(const core::VesselTree& tree);

/// The tree of such a JSON; fails, saying why, when it is none that can be worked with.
core::Result<core::VesselTree> treeFromJson(std::string_view json);

}   // namespace angiopose::io