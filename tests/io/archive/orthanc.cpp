#include "tests/io/archive/orthanc.h"

#include "tests/io/archive/loopback.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace angiopose::test {
namespace {

constexpr const char* program = "/usr/sbin/Orthanc";
constexpr const char* plugin = "/usr/share/orthanc/plugins/libOrthancDicomWeb.so";

bool isListening(int port)
{
    const int handle = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(port);
    const bool connected = ::connect(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(handle);
    return connected;
}

}   // namespace

int freePort()
{
    const int handle = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(0);
    ::bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    socklen_t size = sizeof address;
    ::getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
    ::close(handle);
    return ntohs(address.sin_port);
}

std::optional<TestCertificate> makeCertificate(const TemporaryFolder& folder, const std::string& name)
{
    const TestCertificate made{folder.file(name + ".pem"), folder.file(name + "-key.pem")};
    const std::string command = "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=" + name +
                                " -addext subjectAltName=DNS:localhost,IP:127.0.0.1 -keyout " + made.keyFile +
                                " -out " + made.certificateFile + " 2>/dev/null";
    return std::system(command.c_str()) == 0 ? std::optional(made) : std::nullopt;
}

Orthanc::Orthanc() : dicomPort_(freePort()), httpPort_(freePort()), movePort_(freePort())
{
    certificate_ = makeCertificate(folder_, "archive");
    if (!std::filesystem::exists(program) || !std::filesystem::exists(plugin)) {
        whyNot_ = "orthanc or orthanc-dicomweb is not installed";
    } else if (!certificate_) {
        whyNot_ = "openssl is not installed";
    } else {
        start();
    }
}

void Orthanc::start()
{
    const std::string settings =
        R"({"StorageDirectory":")" + folder_.file("store") + R"(","IndexDirectory":")" + folder_.file("store") +
        R"(","HttpPort":)" + std::to_string(httpPort_) + R"(,"DicomPort":)" + std::to_string(dicomPort_) +
        R"(,"DicomAet":"ORTHANC","DicomCheckCalledAet":true,"RemoteAccessAllowed":false,"AuthenticationEnabled":false,)"
        R"("Plugins":[")" +
        plugin +
        R"("],"DicomAlwaysAllowFind":true,"DicomAlwaysAllowGet":true,"DicomAlwaysAllowMove":true,)"
        R"("DicomModalities":{"us":["ANGIOPOSE","127.0.0.1",)" +
        std::to_string(movePort_) + "]}}";
    const std::string path = folder_.write("orthanc.json", settings);
    const std::string log = folder_.file("orthanc.log");
    process_ = ::fork();
    if (process_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        const int output = ::open(log.c_str(), O_WRONLY | O_CREAT, 0600);
        ::dup2(output, STDOUT_FILENO);
        ::dup2(output, STDERR_FILENO);
        ::execl(program, program, path.c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    for (int tenths = 0; tenths < 600; ++tenths) {
        if (isListening(dicomPort_) && isListening(httpPort_)) {
            proxy_ = std::make_unique<TlsProxy>(httpPort_, certificate_->certificateFile, certificate_->keyFile);
            return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    whyNot_ = "orthanc does not start: " + readText(log);
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = -1;
}

Orthanc::~Orthanc()
{
    if (process_ > 0) {
        ::kill(process_, SIGTERM);
        ::waitpid(process_, nullptr, 0);
    }
}

}   // namespace angiopose::test
