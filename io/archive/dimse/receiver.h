#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/dimse/tls.h"
#include "io/archive/store/arrivals.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Settings of the storage SCP: the port, and which peers may push objects.
struct ReceiverOptions {
    int port = 11112;
    std::string ownTitle = "ANGIOPOSE";   ///< called AE title that we require; empty: any
    std::vector<std::string> titles;   ///< permitted calling AE titles; empty: any
    std::vector<std::string> hosts;   ///< permitted addresses; empty: any
    bool isTls = false;
    TlsFiles tls;
    ExpectedObject expected;   ///< accepts only objects of this study and series; empty: any
    int answerSeconds = 30;   ///< idle timeout of an association, s
};

/// Fails if an AE title is invalid or the TLS files are missing.
core::Status checkReceiver(const ReceiverOptions& options);

/// Storage SCP that also answers C-ECHO. Serves one association at a time; others wait.
class Receiver {
public:
    /// Opens the port; fails if an AE title is invalid, the port is in use, or TLS files are missing or unusable.
    static core::Result<Receiver> listen(const ReceiverOptions& options);

    Receiver(Receiver&&) noexcept;
    Receiver& operator=(Receiver&&) = delete;
    ~Receiver();

    /// Receives objects until stopped, or until nothing more can be stored; `failure` then gives the reason. Failures
    /// of single associations and objects go to the report.
    void serve(Arrivals& arrivals, const StopQuestion& isStopRequested);
    const std::optional<core::Error>& failure() const;

private:
    struct Parts;
    explicit Receiver(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::io
