#pragma once

#include <QFuture>
#include <QFutureWatcher>

namespace angiopose::app {

/// What finished work found, once: a future that kept it would keep closed cases alive. From then on the future is
/// neither running nor finished.
template <typename T>
T takeResult(const QFutureWatcher<T>& watcher)
{
    return watcher.future().takeResult();
}

}   // namespace angiopose::app