#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

class OFCondition;
struct T_ASC_Parameters;

namespace angiopose::io {

/// Why no association came about, as a message to act on.
core::Error requestFailure(const OFCondition& condition, T_ASC_Parameters* parameters, const ArchiveNode& node);

/// Why one ended in the middle.
core::Error associationFailure(const OFCondition& condition, const ArchiveNode& node);

/// That the user wished its end.
core::Error stoppedAssociation(const ArchiveNode& node);

/// Whether there is nobody any more to whom an abort could be told.
bool isConnectionGone(const OFCondition& condition);

}   // namespace angiopose::io
