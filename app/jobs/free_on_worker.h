#pragma once

#include "io/opening/read_inputs.h"

#include <QThreadPool>

#include <memory>
#include <utility>

namespace angiopose::app {

/// Returns a pointer to the same object, which a worker thread frees, whichever thread releases the last reference.
/// Freeing a cine run or scan is slow, since the system reclaims its pages one by one, and would block the window.
template <class T>
std::shared_ptr<const T> freeOnWorker(std::shared_ptr<const T> shared)
{
    if (!shared) {
        return nullptr;
    }
    const T* thing = shared.get();
    return {thing, [shared = std::move(shared)](const T*) mutable {
                QThreadPool::globalInstance()->start([last = std::move(shared)]() mutable { last.reset(); });
            }};
}

/// Does the same for the cine runs and scans of loaded inputs.
io::LoadedInputs freeOnWorker(io::LoadedInputs inputs);

}   // namespace angiopose::app
