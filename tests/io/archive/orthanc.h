#pragma once

#include "tests/io/archive/tls_proxy.h"
#include "tests/support/temporary_folder.h"

#include <sys/types.h>
#include <memory>
#include <optional>
#include <string>

namespace angiopose::test {

/// A port of this computer that nobody listens on.
int freePort();

/// A certificate of localhost with its key, as files of a folder; nothing where openssl is not installed.
struct TestCertificate {
    std::string certificateFile;
    std::string keyFile;
};
std::optional<TestCertificate> makeCertificate(const TemporaryFolder& folder, const std::string& name);

/// A real archive of its own, empty at first: DIMSE in the clear, DICOMweb over HTTPS by a proxy, because HTTPS crashes
/// Debian's Orthanc 1.10.1 itself. Ends with the test.
class Orthanc {
public:
    Orthanc();
    ~Orthanc();
    Orthanc(const Orthanc&) = delete;
    Orthanc& operator=(const Orthanc&) = delete;

    bool isRunning() const { return process_ > 0; }
    const std::string& whyNot() const { return whyNot_; }

    int dicomPort() const { return dicomPort_; }
    int movePort() const { return movePort_; }   ///< where it finds "ANGIOPOSE"
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
