#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace angiopose::test {

/// A port that accepts connections and never sends anything.
class SilentPeer {
public:
    SilentPeer();
    ~SilentPeer();
    SilentPeer(const SilentPeer&) = delete;
    SilentPeer& operator=(const SilentPeer&) = delete;
    int port() const { return port_; }

private:
    int handle_;
    int port_;
};

/// A port with a full queue: connection requests get no answer, as from a host that drops packets.
class SwallowingPeer {
public:
    SwallowingPeer();
    ~SwallowingPeer();
    SwallowingPeer(const SwallowingPeer&) = delete;
    SwallowingPeer& operator=(const SwallowingPeer&) = delete;
    int port() const { return port_; }

private:
    int handle_;
    int port_;
    std::vector<int> waiting_;
};

/// Proxy to another port that cuts the connection, or lets it hang, after a given number of bytes from there.
class CuttingProxy {
public:
    enum class AtEnd { Cut, Hang };
    CuttingProxy(int target, std::size_t bytes, AtEnd atEnd = AtEnd::Cut);
    ~CuttingProxy();
    CuttingProxy(const CuttingProxy&) = delete;
    CuttingProxy& operator=(const CuttingProxy&) = delete;
    int port() const { return port_; }

    void heal() { isHealed_ = true; }

private:
    void run();
    void passOn(int client) const;

    int target_;
    std::size_t bytes_;
    AtEnd atEnd_;
    std::atomic<bool> isHealed_{false};
    std::atomic<bool> isOver_{false};
    int handle_;
    int port_;
    std::thread thread_;
};

}   // namespace angiopose::test
