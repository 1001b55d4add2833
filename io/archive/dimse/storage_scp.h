#pragma once

#include "io/archive/dimse/link.h"
#include "io/archive/dimse/tls.h"
#include "io/archive/store/store_writer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Settings of the storage SCP: port, TLS, and the peers that may push objects.
struct StorageScpOptions {
    int port = 11112;
    std::string ownAeTitle = "ANGIOPOSE";   ///< required called AE title; if empty, any title is accepted
    std::vector<std::string> titles;   ///< permitted calling AE titles; if empty, any title is permitted
    std::vector<std::string> hosts;   ///< permitted host addresses; if empty, any address is permitted
    bool isTls = false;
    TlsFiles tls;
    ExpectedObject expected;   ///< study and series whose objects are accepted; empty identifiers match any
    int responseTimeoutSeconds = 30;   ///< idle timeout of an association, s
};

/// Fails if an AE title is invalid or the TLS files are missing.
core::Status checkStorageScpOptions(const StorageScpOptions& options);

/// Storage SCP that also answers C-ECHO. Serves one association at a time; other peers wait.
class StorageScp {
public:
    /// Opens the port; fails if an AE title is invalid, the port is in use, or the TLS files are missing or unusable.
    static core::Result<StorageScp> listen(const StorageScpOptions& options);

    StorageScp(StorageScp&&) noexcept;
    StorageScp& operator=(StorageScp&&) = delete;
    ~StorageScp();

    /// Receives objects until canceled or until no more objects can be stored, for which `failure` gives the reason.
    /// The report lists failed associations and objects.
    void serve(StoreWriter& storeWriter, const StopCheck& isStopRequested);
    const std::optional<core::Error>& failure() const;

private:
    struct Impl;
    explicit StorageScp(std::unique_ptr<Impl> parts);

    std::unique_ptr<Impl> impl_;
};

}   // namespace angiopose::io
