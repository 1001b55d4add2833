#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

class OFCondition;
struct T_ASC_Parameters;

namespace angiopose::io {

/// Explains why no association could be established, and what to do.
core::Error requestFailure(const OFCondition& condition, T_ASC_Parameters* parameters, const ArchiveNode& node);

/// Explains why an established association ended unexpectedly.
core::Error associationFailure(const OFCondition& condition, const ArchiveNode& node);

/// The error for an association that the user canceled.
core::Error stoppedAssociation(const ArchiveNode& node);

/// Whether the connection is already closed, which makes an abort message pointless.
bool isConnectionGone(const OFCondition& condition);

}   // namespace angiopose::io
