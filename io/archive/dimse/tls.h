#pragma once

#include "core/support/result.h"

#include <memory>
#include <string>
#include <string_view>

class DcmTransportLayer;

namespace angiopose::io {

enum class TlsRole { Asks, IsAsked };

/// PEM files of one side of a TLS connection.
struct TlsFiles {
    std::string caFile;   ///< empty: the system's certificate authorities
    std::string certificateFile;
    std::string keyFile;
};

struct DeleteTransportLayer {
    void operator()(DcmTransportLayer* layer) const;
};
using TransportLayer = std::unique_ptr<DcmTransportLayer, DeleteTransportLayer>;

/// Creates a TLS layer according to BCP 195 (PS3.15 B.9), which requires valid certificates of both sides. Fails,
/// naming the file, if one is unusable.
core::Result<TransportLayer> makeTlsLayer(const TlsFiles& files, TlsRole role);

/// Whether a certificate (DER) was issued for the host.
bool isCertificateOf(std::string_view certificate, const std::string& host);

}   // namespace angiopose::io
