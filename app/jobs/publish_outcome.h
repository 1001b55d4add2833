#pragma once

#include "core/support/result.h"

namespace angiopose::app {

/// How a job ends: `finished` with what was found, or `failed` with the reason.
template <class Job, class Found>
void publishOutcome(Job& job, const core::Result<Found>& outcome)
{
    if (outcome) {
        emit job.finished(outcome.value());
    } else {
        emit job.failed(outcome.error().message);
    }
}

}   // namespace angiopose::app