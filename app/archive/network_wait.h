#pragma once

#include <QThreadPool>

namespace angiopose::app {

/// Releases the worker's thread-pool slot while the worker waits for the network, so that another worker can compute.
class NetworkWait {
public:
    NetworkWait() { QThreadPool::globalInstance()->releaseThread(); }
    ~NetworkWait() { QThreadPool::globalInstance()->reserveThread(); }
    NetworkWait(const NetworkWait&) = delete;
    NetworkWait& operator=(const NetworkWait&) = delete;
};

}   // namespace angiopose::app
