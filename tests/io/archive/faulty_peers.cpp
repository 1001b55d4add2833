#include "tests/io/archive/faulty_peers.h"

#include "tests/io/archive/loopback.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <algorithm>
#include <array>

namespace angiopose::test {
namespace {

int listeningSocket(int queue, int& port)
{
    const int handle = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = loopback(0);
    ::bind(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(handle, queue);
    socklen_t size = sizeof address;
    ::getsockname(handle, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
    return handle;
}

/// Passes one block on, at most `room` bytes, and subtracts its size; returns false when there is nothing more to pass.
bool passBlock(int from, int to, std::size_t& room)
{
    std::array<char, 4096> block{};
    const ssize_t got = ::recv(from, block.data(), std::min(block.size(), room), 0);
    if (got <= 0) {
        return false;
    }
    room -= static_cast<std::size_t>(got);
    return ::send(to, block.data(), static_cast<std::size_t>(got), MSG_NOSIGNAL) == got;
}

}   // namespace

SilentPeer::SilentPeer() : handle_(-1), port_(0)
{
    handle_ = listeningSocket(16, port_);
}

SilentPeer::~SilentPeer()
{
    ::close(handle_);
}

SwallowingPeer::SwallowingPeer() : handle_(-1), port_(0)
{
    handle_ = listeningSocket(0, port_);
    const sockaddr_in address = loopback(port_);
    for (int i = 0; i < 4; ++i) {
        const int waiting = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        ::connect(waiting, reinterpret_cast<const sockaddr*>(&address), sizeof address);
        waiting_.push_back(waiting);
    }
}

SwallowingPeer::~SwallowingPeer()
{
    for (const int waiting : waiting_) {
        ::close(waiting);
    }
    ::close(handle_);
}

CuttingProxy::CuttingProxy(int target, std::size_t bytes, AtEnd atEnd)
    : target_(target), bytes_(bytes), atEnd_(atEnd), handle_(-1), port_(0)
{
    handle_ = listeningSocket(16, port_);
    thread_ = std::thread([this] { run(); });
}

CuttingProxy::~CuttingProxy()
{
    isOver_ = true;
    thread_.join();
    ::close(handle_);
}

void CuttingProxy::run()
{
    while (!isOver_) {
        if (isReadable(handle_, 50)) {
            const int client = ::accept(handle_, nullptr, nullptr);
            passOn(client);
            ::close(client);
        }
    }
}

void CuttingProxy::passOn(int client) const
{
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(target_);
    ::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    std::size_t back = isHealed_ ? std::size_t{1} << 40 : bytes_;
    std::size_t there = std::size_t{1} << 40;
    while (!isOver_ && back > 0) {
        std::array<pollfd, 2> ends{pollfd{client, POLLIN, 0}, pollfd{server, POLLIN, 0}};
        ::poll(ends.data(), ends.size(), 50);
        if (ends[0].revents != 0 && !passBlock(client, server, there)) {
            break;
        }
        if (ends[1].revents != 0 && !passBlock(server, client, back)) {
            break;
        }
    }
    while (atEnd_ == AtEnd::Hang && back == 0 && !isOver_ && !isReadable(client, 50)) {
    }
    ::close(server);
}

}   // namespace angiopose::test
