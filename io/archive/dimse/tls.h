#pragma once

#include "core/support/result.h"

#include <memory>
#include <string>
#include <string_view>

class DcmTransportLayer;

namespace angiopose::io {

enum class TlsRole { Client, Server };

/// PEM files for one end of a TLS connection.
struct TlsFiles {
    std::string caFile;   ///< if empty, the system's certificate authorities
    std::string certificateFile;
    std::string keyFile;
};

struct DeleteTransportLayer {
    void operator()(DcmTransportLayer* layer) const;
};
using TransportLayer = std::unique_ptr<DcmTransportLayer, DeleteTransportLayer>;

/// Creates a TLS layer that conforms to BCP 195 (PS3.15 B.9) and requires valid certificates from both peers. Fails and
/// names the file if one is unusable.
core::Result<TransportLayer> makeTlsLayer(const TlsFiles& files, TlsRole role);

/// Returns whether a certificate (DER) was issued for `host`.
bool isCertificateForHost(std::string_view certificate, const std::string& host);

}   // namespace angiopose::io
