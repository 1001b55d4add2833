#pragma once

#include <QThreadPool>

namespace angiopose::app {

/// Releases the worker's thread-pool slot while the worker waits for the network, so that another worker can compute.
class ThreadPoolRelease {
public:
    ThreadPoolRelease() { QThreadPool::globalInstance()->releaseThread(); }
    ~ThreadPoolRelease() { QThreadPool::globalInstance()->reserveThread(); }
    ThreadPoolRelease(const ThreadPoolRelease&) = delete;
    ThreadPoolRelease& operator=(const ThreadPoolRelease&) = delete;
};

}   // namespace angiopose::app
