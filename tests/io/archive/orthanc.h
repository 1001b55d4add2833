#pragma once

#include "tests/io/archive/tls_proxy.h"
#include "tests/support/temporary_folder.h"

#include <sys/types.h>
#include <memory>
#include <optional>
#include <string>

namespace angiopose::test {

/// A local port that nothing listens on.
int freePort();

/// A certificate for localhost with its key, as files of a folder; empty if openssl is not installed.
struct TestCertificate {
    std::string certificateFile;
    std::string keyFile;
};
std::optional<TestCertificate> makeCertificate(const TemporaryFolder& folder, const std::string& name);

/// A separate real archive, empty at first: unencrypted DIMSE, and DICOMweb over HTTPS through a proxy, because HTTPS
/// crashes Debian's Orthanc 1.10.1 itself. Ends with the test.
class Orthanc {
public:
    Orthanc();
    ~Orthanc();
    Orthanc(const Orthanc&) = delete;
    Orthanc& operator=(const Orthanc&) = delete;

    bool isRunning() const { return process_ > 0; }
    const std::string& whyNot() const { return whyNot_; }

    int dicomPort() const { return dicomPort_; }
    int movePort() const { return movePort_; }   ///< port where it expects "ANGIOPOSE" as move destination
    std::string webUrl() const
    {
        return "https://localhost:" + std::to_string(proxy_ ? proxy_->port() : 0) + "/dicom-web";
    }
    std::string caFile() const { return certificate_ ? certificate_->certificateFile : ""; }

    static constexpr const char* title = "ORTHANC";

private:
    void start();

    TemporaryFolder folder_;
    std::optional<TestCertificate> certificate_;
    std::string whyNot_;
    pid_t process_ = -1;
    int dicomPort_ = 0;
    int httpPort_ = 0;
    int movePort_ = 0;
    std::unique_ptr<TlsProxy> proxy_;
};

}   // namespace angiopose::test
