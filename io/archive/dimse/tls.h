#pragma once

#include "core/support/result.h"

#include <memory>
#include <string>
#include <string_view>

class DcmTransportLayer;

namespace angiopose::io {

enum class TlsRole { Asks, IsAsked };

/// Files of one side of a secured connection, PEM.
struct TlsFiles {
    std::string caFile;   ///< empty: the authorities that the system trusts
    std::string certificateFile;
    std::string keyFile;
};

struct DeleteTransportLayer {
    void operator()(DcmTransportLayer* layer) const;
};
using TransportLayer = std::unique_ptr<DcmTransportLayer, DeleteTransportLayer>;

/// TLS after BCP 195 (PS3.15 B.9), in which both sides must show certificates that check. Fails, naming the file, on
/// one that is of no use.
core::Result<TransportLayer> makeTlsLayer(const TlsFiles& files, TlsRole role);

/// Whether a certificate (DER) is one of the host.
bool isCertificateOf(std::string_view certificate, const std::string& host);

}   // namespace angiopose::io
