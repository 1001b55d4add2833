#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"
#include "io/case/fields/schema_words.h"

namespace angiopose::io {

/// A vessel tree as the JSON that a case keeps under `vessel.editedTree`, exact to the last bit.
Json treeJson(const core::VesselTree& tree);

/// The tree of such a JSON, which follows the schema; fails, saying why, when it is none that can be worked with.
core::Result<core::VesselTree> treeFromJson(const Json& json);

/// What such a JSON has to be.
Json treeSchema();

}   // namespace angiopose::io