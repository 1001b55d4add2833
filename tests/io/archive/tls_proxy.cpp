#include "tests/io/archive/tls_proxy.h"

#include "tests/io/archive/loopback.h"

#include <openssl/ssl.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>

namespace angiopose::test {
namespace {

bool toServer(SSL* from, int to)
{
    std::array<char, 16384> block{};
    const int got = SSL_read(from, block.data(), static_cast<int>(block.size()));
    return got > 0 && ::send(to, block.data(), static_cast<std::size_t>(got), MSG_NOSIGNAL) == got;
}

bool toClient(int from, SSL* to)
{
    std::array<char, 16384> block{};
    const ssize_t got = ::recv(from, block.data(), block.size(), 0);
    return got > 0 && SSL_write(to, block.data(), static_cast<int>(got)) == got;
}

}   // namespace

TlsProxy::TlsProxy(int target, const std::string& certificateFile, const std::string& keyFile)
    : target_(target), context_(SSL_CTX_new(TLS_server_method()))
{
    ::signal(SIGPIPE, SIG_IGN);
    auto* context = static_cast<SSL_CTX*>(context_);
    SSL_CTX_use_certificate_file(context, certificateFile.c_str(), SSL_FILETYPE_PEM);
    SSL_CTX_use_PrivateKey_file(context, keyFile.c_str(), SSL_FILETYPE_PEM);
    handle_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(0);
    ::bind(handle_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(handle_, 16);
    socklen_t size = sizeof address;
    ::getsockname(handle_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { run(); });
}

TlsProxy::~TlsProxy()
{
    isOver_ = true;
    thread_.join();
    for (std::thread& each : served_) {
        each.join();
    }
    ::close(handle_);
    SSL_CTX_free(static_cast<SSL_CTX*>(context_));
}

void TlsProxy::run()
{
    while (!isOver_) {
        if (isReadable(handle_, 50)) {
            const int client = ::accept(handle_, nullptr, nullptr);
            served_.emplace_back([this, client] { serve(client); });
        }
    }
}

void TlsProxy::serve(int client) const
{
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(target_);
    SSL* secure = SSL_new(static_cast<SSL_CTX*>(context_));
    SSL_set_fd(secure, client);
    const bool isReady =
        SSL_accept(secure) == 1 && ::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    for (bool isOpen = isReady; isOpen && !isOver_;) {
        if (SSL_pending(secure) > 0 || isReadable(client, 5)) {
            isOpen = toServer(secure, server);
        }
        if (isOpen && isReadable(server, 5)) {
            isOpen = toClient(server, secure);
        }
    }
    SSL_free(secure);
    ::close(server);
    ::close(client);
}

}   // namespace angiopose::test
