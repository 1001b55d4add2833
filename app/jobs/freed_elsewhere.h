#pragma once

#include "io/opening/read_inputs.h"

#include <QThreadPool>

#include <memory>
#include <utility>

namespace angiopose::app {

/// The same thing, for the window: whoever lets go of it last, a worker gives its memory back. The system takes the
/// pages of a run or a scan back one by one, and the window would stand still meanwhile.
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

/// Likewise the runs and scans in what was read.
io::LoadedInputs freedElsewhere(io::LoadedInputs inputs);

}   // namespace angiopose::app