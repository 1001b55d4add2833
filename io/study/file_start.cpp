#include "io/study/file_start.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/system/files.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t blockSize = std::size_t{1} << 20;

}   // namespace

core::Result<FileStart> readFileStart(const std::string& path, std::size_t size, const ReadObserver& observe)
{
    ReadHandle file(path);
    if (!file.isOpen()) {
        return fileError(path, messages::fileNotOpened(file.problem()));
    }
    if (!file.isRegular()) {
        return fileError(path, messages::fileNotRegular());
    }
    if (file.size() == 0) {
        return fileError(path, messages::fileEmpty());
    }
    FileStart start;
    start.fileSize = file.size();
    const std::size_t wanted = std::min(size, start.fileSize);
    start.bytes.resize(wanted);
    for (std::size_t at = 0; at < wanted;) {
        if (isStopRequested(observe, static_cast<double>(at) / static_cast<double>(wanted))) {
            return readingCanceled(path);
        }
        const std::size_t got = file.read(start.bytes.data() + at, std::min(blockSize, wanted - at));
        if (got == 0) {
            return fileError(path, messages::fileNotRead(file.problem()));
        }
        at += got;
    }
    return start;
}

}   // namespace angiopose::io
