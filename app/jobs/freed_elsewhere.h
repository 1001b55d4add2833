#pragma once

#include "io/opening/read_inputs.h"

#include <QThreadPool>

#include <memory>
#include <utility>

namespace angiopose::app {

/// Shares the same object, but frees it on a worker thread, whoever releases the last reference: the system reclaims
/// the pages of a cine run or scan one by one, which would block the window.
template <class T>
std::shared_ptr<const T> freedElsewhere(std::shared_ptr<const T> shared)
{
    if (!shared) {
        return nullptr;
    }
    const T* thing = shared.get();
    return {thing, [shared = std::move(shared)](const T*) mutable {
                QThreadPool::globalInstance()->start([last = std::move(shared)]() mutable { last.reset(); });
            }};
}

/// The same for the cine runs and scans among loaded inputs.
io::LoadedInputs freedElsewhere(io::LoadedInputs inputs);

}   // namespace angiopose::app