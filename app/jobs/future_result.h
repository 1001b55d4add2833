#pragma once

#include <QFuture>
#include <QFutureWatcher>

namespace angiopose::app {

/// Takes the result of completed work out of its watcher, once; a future that kept it would keep closed cases alive.
/// Afterwards the future is neither running nor finished.
template <typename T>
T takeResult(const QFutureWatcher<T>& watcher)
{
    return watcher.future().takeResult();
}

}   // namespace angiopose::app