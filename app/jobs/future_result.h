#pragma once

#include <QFuture>
#include <QFutureWatcher>

namespace angiopose::app {

/// Moves the result of completed work out of its watcher; call it once. A future that kept its result would keep closed
/// cases in memory. Afterwards the future is neither running nor finished.
template <typename T>
T takeResult(const QFutureWatcher<T>& watcher)
{
    return watcher.future().takeResult();
}

}   // namespace angiopose::app
