#pragma once

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"
#include "io/case/fields/schema_words.h"

namespace angiopose::io {

/// A vessel tree as the JSON stored under `vessel.editedTree`, with all bits of every double.
Json treeJson(const core::VesselTree& tree);

/// Reads a tree from such JSON, which must conform to the schema; fails with a reason if the tree is not usable.
core::Result<core::VesselTree> treeFromJson(const Json& json);

/// The schema of such JSON.
Json treeSchema();

}   // namespace angiopose::io