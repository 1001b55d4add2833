#include "io/archive/store/sendable_file.h"

#include "io/archive/model/query.h"
#include "io/dicom/element_filter.h"
#include "io/messages/messages.h"
#include "io/study/file_start.h"
#include "io/study/study_file.h"

namespace angiopose::io {
namespace {

constexpr std::size_t metaBegin = 132;
constexpr std::size_t maxMetaBytes = std::size_t{64} << 10;

/// Returns the offset of the data set after the preamble and the file meta information; 0 if the file has neither.
std::size_t datasetOffset(std::string_view start)
{
    if (start.size() < metaBegin || start.substr(metaBegin - 4, 4) != "DICM") {
        return 0;
    }
    std::size_t at = metaBegin;
    while (const auto head = readElementHeader(start.substr(at), DicomEncoding())) {
        if (head->tag >> 16U != 0x0002) {
            return at;
        }
        if (head->length > start.size() - at - head->size) {
            return 0;
        }
        at += head->size + head->length;
    }
    return 0;
}

}   // namespace

core::Result<SendableFile> readSendableFile(const std::string& path)
{
    const auto start = readFileStart(path, maxMetaBytes);
    if (!start) {
        return start.error();
    }
    const auto read = readStudyFile(path);
    if (!read || !read.value()) {
        return core::Error(messages::archiveNotSendable().about(path));
    }
    const DicomImages& images = read.value()->images;
    SendableFile file;
    file.path = path;
    file.sopClass = images.sopClassUid;
    file.sopInstance = images.identity.sopInstanceUid;
    file.studyUid = images.identity.studyUid;
    file.transferSyntax = read.value()->transferSyntax;
    file.dataset = datasetOffset(start.value().bytes);
    file.bytes = start.value().fileSize;
    const bool isComplete = file.dataset > 0 && !images.damage && (file.bytes - file.dataset) % 2 == 0;
    if (!isComplete || !isUid(file.sopClass) || !isUid(file.sopInstance) || !isUid(file.transferSyntax)) {
        return core::Error(messages::archiveNotSendable().about(path));
    }
    return file;
}

}   // namespace angiopose::io
