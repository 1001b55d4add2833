#include "io/support/read_error.h"

#include "io/messages/says.h"

#include <sys/mman.h>
#include <cerrno>
#include <cstring>

namespace angiopose::io {

std::optional<core::Message> findReadError(const char* mapping, std::size_t size)
{
    while (::madvise(const_cast<char*>(mapping), size, MADV_POPULATE_READ) != 0) {
        if (errno == EINVAL || errno == ENOSYS) {
            return std::nullopt;
        }
        if (errno != EINTR && errno != EAGAIN) {   // EFAULT: to look would raise SIGBUS
            return says::fileNotRead(std::strerror(errno == EFAULT ? EIO : errno));
        }
    }
    return std::nullopt;
}

}   // namespace angiopose::io
