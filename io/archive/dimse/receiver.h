#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/dimse/tls.h"
#include "io/archive/store/arrivals.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Who may push objects to us, and how.
struct ReceiverOptions {
    int port = 11112;
    std::string ownTitle = "ANGIOPOSE";   ///< by which we must be called; empty: any
    std::vector<std::string> titles;   ///< that may call; empty: any
    std::vector<std::string> hosts;   ///< addresses that may call; empty: any
    bool isTls = false;
    TlsFiles tls;
    ExpectedObject expected;   ///< only objects of this study and series; empty: any
    int answerSeconds = 30;   ///< an association on which nothing comes for so long is ended
};

/// Fails where a title is none, or TLS lacks its files.
core::Status checkReceiver(const ReceiverOptions& options);

/// A port to which others push objects (C-STORE SCP, C-ECHO too). One association at a time; others wait.
class Receiver {
public:
    /// Fails where a title is none, the port is taken, or TLS files are lacking or of no use.
    static core::Result<Receiver> listen(const ReceiverOptions& options);

    Receiver(Receiver&&) noexcept;
    Receiver& operator=(Receiver&&) = delete;
    ~Receiver();

    /// Takes objects until told to stop, or until no more can be taken: then `failure` says why. What goes wrong with
    /// single associations and objects is noted in the report.
    void serve(Arrivals& arrivals, const StopQuestion& isStopRequested);
    const std::optional<core::Error>& failure() const;

private:
    struct Parts;
    explicit Receiver(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}   // namespace angiopose::io
