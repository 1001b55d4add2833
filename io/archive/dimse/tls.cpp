#include "io/archive/dimse/tls.h"

#include "io/messages/messages.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmtls/tlslayer.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <mutex>

namespace angiopose::io {
namespace {

core::Error uselessFile(const std::string& path, const OFCondition& why)
{
    return messages::archiveTlsFile(path, why.text());
}

core::Status trustCertificates(DcmTLSTransportLayer& layer, const std::string& caFile)
{
    if (caFile.empty()) {
        SSL_CTX_set_default_verify_paths(layer.getNativeHandle());
        return core::Done{};
    }
    const OFCondition added = layer.addTrustedCertificateFile(caFile.c_str(), DCF_Filetype_PEM);
    return added.good() ? core::Status(core::Done{}) : core::Status(uselessFile(caFile, added));
}

core::Status showCertificate(DcmTLSTransportLayer& layer, const TlsFiles& files)
{
    if (files.certificateFile.empty()) {
        return core::Done{};
    }
    layer.setPrivateKeyPasswd("");   // suppresses the password prompt
    if (const OFCondition set = layer.setPrivateKeyFile(files.keyFile.c_str(), DCF_Filetype_PEM); set.bad()) {
        return uselessFile(files.keyFile, set);
    }
    if (const OFCondition set = layer.setCertificateFile(files.certificateFile.c_str(), DCF_Filetype_PEM); set.bad()) {
        return uselessFile(files.certificateFile, set);
    }
    if (!layer.checkPrivateKeyMatchesCertificate()) {
        return core::Error(
            messages::archiveTlsFile(files.keyFile, "it is not the private key of " + files.certificateFile));
    }
    return core::Done{};
}

}   // namespace

void DeleteTransportLayer::operator()(DcmTransportLayer* layer) const
{
    delete layer;
}

core::Result<TransportLayer> makeTlsLayer(const TlsFiles& files, TlsRole role)
{
    static std::once_flag once;
    std::call_once(once, [] { DcmTLSTransportLayer::initializeOpenSSL(); });
    auto layer = std::make_unique<DcmTLSTransportLayer>(role == TlsRole::Client ? NET_REQUESTOR : NET_ACCEPTOR, nullptr,
                                                        OFFalse);
    if (const OFCondition set = layer->setTLSProfile(TSP_Profile_BCP195); set.bad()) {
        return core::Error(messages::archiveTlsRefused(set.text()));
    }
    if (auto trusted = trustCertificates(*layer, files.caFile); !trusted) {
        return trusted.error();
    }
    if (auto shown = showCertificate(*layer, files); !shown) {
        return shown.error();
    }
    if (const OFCondition set = layer->activateCipherSuites(); set.bad()) {
        return core::Error(messages::archiveTlsRefused(set.text()));
    }
    layer->setCertificateVerification(DCV_requireCertificate);
    return TransportLayer(layer.release());
}

bool isCertificateForHost(std::string_view certificate, const std::string& host)
{
    const auto* bytes = reinterpret_cast<const unsigned char*>(certificate.data());
    X509* parsed = d2i_X509(nullptr, &bytes, static_cast<long>(certificate.size()));
    if (parsed == nullptr) {
        return false;
    }
    const bool isHost = X509_check_host(parsed, host.c_str(), host.size(), 0, nullptr) == 1 ||
                        X509_check_ip_asc(parsed, host.c_str(), 0) == 1;
    X509_free(parsed);
    return isHost;
}

}   // namespace angiopose::io
