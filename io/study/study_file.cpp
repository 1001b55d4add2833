#include "io/study/study_file.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/frame_time.h"
#include "io/messages/messages.h"
#include "io/study/file_start.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t firstBytes = std::size_t{64} << 10;   // sufficient for the header of nearly every slice and run
constexpr std::size_t growth = 4;
constexpr std::size_t maxHeaderBytes = std::size_t{64} << 20;
constexpr std::string_view deflatedSyntax = "1.2.840.10008.1.2.1.99";

/// Reports a file that is too short for the uncompressed pixels declared in its header.
std::optional<core::Message> findTruncation(const DicomFile& file, const FileStart& start)
{
    const auto pixels = file.pixels.find(pixelDataTag);
    if (pixels == file.pixels.end() || pixels->second.isEncapsulated || file.transferSyntax == deflatedSyntax) {
        return std::nullopt;
    }
    const DicomDataset& data = file.dataset;
    const auto positive = [&data](DicomTag tag, int fallback) {
        return static_cast<std::size_t>(std::max(data.integer(tag).value_or(fallback), 0));
    };
    const bool isHalved = data.text(0x00280004) == "YBR_FULL_422";
    const std::size_t samples = isHalved ? 2 : positive(0x00280002, 1);
    const std::size_t bits = positive(0x00280010, 0) * positive(0x00280011, 0) * positive(0x00280008, 1) * samples *
                             positive(0x00280100, 16);
    const auto begin = static_cast<std::size_t>(pixels->second.bytes.data() - start.bytes.data());
    const std::size_t there = start.fileSize - std::min(begin, start.fileSize);
    return there < bits / 8 ? std::optional(core::Message(messages::dicomPixelsCutShort(there, bits / 8)))
                            : std::nullopt;
}

StudyFile studyFileOf(const DicomFile& file, const FileStart& start, const std::string& path)
{
    const DicomDataset& data = file.dataset;
    StudyFile result;
    result.path = path;
    result.images = imagesOf(file, path);
    result.images.damage = file.pixels.empty() ? file.damage : findTruncation(file, start);
    result.studyDescription = utf8Text(data, 0x00081030);
    result.bodyPart = utf8Text(data, 0x00180015);
    result.imageType = data.text(0x00080008);
    result.transferSyntax = file.transferSyntax;
    result.frames = std::max(data.integer(0x00280008).value_or(1), 1);
    result.samples = data.integer(0x00280002).value_or(1);
    result.frameTimeMs = frameTimeOf(data).ms;
    return result;
}

/// Reads a gzip file, which must be decompressed to find out whether it contains DICOM.
std::optional<StudyFile> readPacked(const std::string& path)
{
    const auto input = openDicom(path);
    if (!input) {
        return std::nullopt;
    }
    const auto parsed = parseDicom(input.value().view(), path);
    if (!parsed) {
        return std::nullopt;
    }
    FileStart unpacked;
    unpacked.fileSize = input.value().view().size();
    StudyFile file = studyFileOf(parsed.value(), unpacked, path);
    file.images.damage = parsed.value().damage;
    return file;
}

bool isSayingDicom(std::string_view bytes)
{
    return bytes.size() >= 132 && bytes.substr(128, 4) == "DICM";
}

}   // namespace

core::Result<std::optional<StudyFile>> readStudyFile(const std::string& path)
{
    for (std::size_t size = firstBytes;; size *= growth) {
        auto read = readFileStart(path, size);
        if (!read) {
            return read.error();
        }
        const FileStart& start = read.value();
        if (start.bytes.starts_with("\x1f\x8b")) {
            return extensionOf(path) == ".nii.gz" ? std::nullopt : readPacked(path);
        }
        if (!looksLikeDicom(start.bytes)) {
            return std::optional<StudyFile>();
        }
        const auto parsed = parseDicom(start.bytes, path);
        const bool isLast = start.isComplete() || size >= maxHeaderBytes;
        if (parsed && (isLast || !parsed.value().pixels.empty())) {
            return std::optional(studyFileOf(parsed.value(), start, path));
        }
        if (isLast) {   // so few bytes may resemble a data set by chance
            return isSayingDicom(start.bytes) ? core::Result<std::optional<StudyFile>>(parsed.error())
                                              : std::optional<StudyFile>();
        }
    }
}

}   // namespace angiopose::io
