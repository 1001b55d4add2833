#pragma once

#include <QThreadPool>

namespace angiopose::app {

/// While it lives, the worker that made it waits for a network: one more may compute meanwhile.
class NetworkWait {
public:
    NetworkWait() { QThreadPool::globalInstance()->releaseThread(); }
    ~NetworkWait() { QThreadPool::globalInstance()->reserveThread(); }
    NetworkWait(const NetworkWait&) = delete;
    NetworkWait& operator=(const NetworkWait&) = delete;
};

}   // namespace angiopose::app
