#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/dimse/tls.h"
#include "io/archive/store/arrivals.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Settings of the storage SCP: port, TLS, and the peers that may push objects.
struct ReceiverOptions {
    int port = 11112;
    std::string ownTitle = "ANGIOPOSE";   ///< required called AE title; if empty, any title is accepted
    std::vector<std::string> titles;   ///< permitted calling AE titles; if empty, any title
    std::vector<std::string> hosts;   ///< permitted host addresses; if empty, any address
    bool isTls = false;
    TlsFiles tls;
    ExpectedObject expected;   ///< study and series whose objects are accepted; empty identifiers match any
    int answerSeconds = 30;   ///< idle timeout of an association, s
};

/// Fails if an AE title is invalid or the TLS files are missing.
core::Status checkReceiver(const ReceiverOptions& options);

/// Storage SCP that also answers C-ECHO. Serves one association at a time; other callers wait.
class Receiver {
public:
    /// Opens the port; fails if an AE title is invalid, the port is in use, or TLS files are missing or unusable.
    static core::Result<Receiver> listen(const ReceiverOptions& options);

    Receiver(Receiver&&) noexcept;
    Receiver& operator=(Receiver&&) = delete;
    ~Receiver();

    /// Receives objects until canceled or until no more objects can be stored; `failure` then gives the reason. The
    /// report lists failures of single associations and objects.
    void serve(Arrivals& arrivals, const StopQuestion& isStopRequested);
    const std::optional<core::Error>& failure() const;

private:
    struct Parts;
    explicit Receiver(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::io
