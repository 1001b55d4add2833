#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace angiopose::test {

/// Accepts TLS on its own port and forwards the data unencrypted to another port.
class TlsProxy {
public:
    TlsProxy(int target, const std::string& certificateFile, const std::string& keyFile);
    ~TlsProxy();
    TlsProxy(const TlsProxy&) = delete;
    TlsProxy& operator=(const TlsProxy&) = delete;
    int port() const { return port_; }

private:
    void run();
    void serve(int client) const;

    int target_;
    void* context_;   ///< SSL_CTX
    int handle_ = -1;
    int port_ = 0;
    std::atomic<bool> isOver_{false};
    std::vector<std::thread> served_;
    std::thread thread_;
};

}   // namespace angiopose::test
