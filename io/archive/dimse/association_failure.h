#pragma once

#include "core/support/result.h"
#include "io/archive/model/node.h"

class OFCondition;
struct T_ASC_Parameters;

namespace angiopose::io {

/// Explains why the association could not be established and how to fix the problem.
core::Error associationRequestError(const OFCondition& condition, T_ASC_Parameters* parameters,
                                    const ArchiveNode& node);

/// Explains why an established association ended unexpectedly.
core::Error associationError(const OFCondition& condition, const ArchiveNode& node);

/// Returns the error for an association that the user canceled.
core::Error canceledAssociationError(const ArchiveNode& node);

/// Returns whether the connection is already closed, in which case sending an abort is pointless.
bool isConnectionClosed(const OFCondition& condition);

}   // namespace angiopose::io
