#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <cstdint>

namespace angiopose::test {

inline sockaddr_in loopback(int port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

inline bool isReadable(int handle, int milliseconds)
{
    pollfd waited{handle, POLLIN, 0};
    return ::poll(&waited, 1, milliseconds) > 0;
}

}   // namespace angiopose::test
