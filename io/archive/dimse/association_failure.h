#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

class OFCondition;
struct T_ASC_Parameters;

namespace angiopose::io {

/// Explains why the association could not be established and how to fix the problem.
core::Error requestFailure(const OFCondition& condition, T_ASC_Parameters* parameters, const ArchiveNode& node);

/// Explains why an established association ended unexpectedly.
core::Error associationFailure(const OFCondition& condition, const ArchiveNode& node);

/// Returns the error for an association that the user canceled.
core::Error stoppedAssociation(const ArchiveNode& node);

/// Whether the connection is already closed, so that sending an abort is pointless.
bool isConnectionGone(const OFCondition& condition);

}   // namespace angiopose::io
