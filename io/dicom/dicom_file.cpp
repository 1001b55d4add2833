#include "io/dicom/dicom_file.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/inflate.h"

namespace angiopose::io {
namespace {

constexpr std::size_t preambleSize = 128;
constexpr std::string_view magic = "DICM";
constexpr std::string_view deflatedSyntax = "1.2.840.10008.1.2.1.99";
constexpr std::string_view bigEndianSyntax = "1.2.840.10008.1.2.2";
constexpr std::size_t maxDatasetBytes = std::size_t{128} << 20;   // bytes, uncompressed, like the next constant
constexpr std::size_t maxFileBytes = std::size_t{256} << 20;
constexpr std::size_t packedStart =
    4096;   // bytes to decompress to recognize DICOM, so that large scans are not decompressed entirely
constexpr DicomTag transferSyntaxTag = 0x00020010;

bool hasPreamble(std::string_view content)
{
    return content.size() > preambleSize + magic.size() && content.substr(preambleSize).starts_with(magic);
}

/// Returns whether `bytes` start with a data set: the first element has a small group number in one of the byte orders.
bool startsLikeDataset(std::string_view bytes)
{
    if (bytes.size() < 8) {
        return false;
    }
    const auto isPlausible = [&](ByteOrder order) {
        const auto head = readElementHeader(bytes, DicomEncoding{true, order});
        const DicomTag group = head ? head->tag >> 16 : 0;
        return (group == 0x0002 || group == 0x0008) && (head->tag & 0xffff) < 0x0100 && head->length <= bytes.size();
    };
    return isPlausible(ByteOrder::Little) || isPlausible(ByteOrder::Big);
}

/// Determines the encoding of the data set. VR letters in the data override a wrong or missing transfer syntax.
DicomEncoding encodingOf(std::string_view bytes, std::string_view transferSyntax)
{
    DicomEncoding encoding;
    if (bytes.size() >= 6) {
        const auto isUpper = [](char c) { return c >= 'A' && c <= 'Z'; };
        encoding.isExplicit = isUpper(bytes[4]) && isUpper(bytes[5]);
        const bool looksBig = readUint16(bytes, ByteOrder::Big) < readUint16(bytes, ByteOrder::Little);
        const bool isBig = transferSyntax.empty() ? looksBig : transferSyntax == bigEndianSyntax;
        encoding.order = isBig ? ByteOrder::Big : ByteOrder::Little;
    }
    return encoding;
}

/// Reads the file meta information (always explicit VR little endian) and advances `rest` to the data set.
std::string readMeta(std::string_view& rest)
{
    constexpr DicomEncoding encoding;
    std::string syntax;
    while (const auto head = readElementHeader(rest, encoding)) {
        if (head->tag >> 16 != 0x0002 || head->length > rest.size() - head->size) {
            break;
        }
        if (head->tag == transferSyntaxTag) {
            syntax = rest.substr(head->size, head->length);
            syntax.erase(syntax.find_last_not_of(std::string_view(" \0", 2)) + 1);
        }
        rest.remove_prefix(head->size + head->length);
    }
    return syntax;
}

}   // namespace

bool looksLikeDicom(std::string_view content)
{
    return hasPreamble(content) || content.starts_with(magic) || startsLikeDataset(content);
}

bool isGzippedDicom(std::string_view content)
{
    return content.starts_with("\x1f\x8b") && looksLikeDicom(decompressStart(content, packedStart));
}

core::Result<InputBytes> openDicom(const std::string& path)
{
    auto input = openInput(path);
    if (!input) {
        return input;
    }
    if (looksLikeDicom(input.value().view())) {
        return input;
    }
    if (isGzippedDicom(input.value().view())) {
        auto unpacked = decompress(input.value().view(), CompressionFormat::Gzip, maxFileBytes);
        if (unpacked && looksLikeDicom(*unpacked)) {
            return InputBytes(std::move(*unpacked));
        }
    }
    return fileError(path, messages::dicomNotOne());
}

bool isDicomFile(const std::string& path)
{
    const auto start = openInputStart(path);
    return start && (looksLikeDicom(start.value().view()) || isGzippedDicom(start.value().view()));
}

core::Result<DicomFile> parseDicom(std::string_view content, const std::string& path)
{
    std::string_view rest = content;
    if (hasPreamble(content)) {
        rest.remove_prefix(preambleSize + magic.size());
    } else if (content.starts_with(magic)) {
        rest.remove_prefix(magic.size());
    }
    DicomFile file;
    file.transferSyntax = readMeta(rest);
    if (file.transferSyntax == deflatedSyntax) {
        auto unpacked = decompress(rest, CompressionFormat::RawDeflate, maxDatasetBytes);
        if (!unpacked) {
            return fileError(path, messages::dicomDeflateDamaged());
        }
        file.unpacked = InputBytes(std::move(*unpacked));
        rest = file.unpacked.view();
    }
    const DicomEncoding encoding = encodingOf(rest, file.transferSyntax);
    FilteredElements passed = filterElements(rest, encoding);
    if (passed.isEmpty) {
        return fileError(path, messages::dicomNoElement());
    }
    file.dataset = readElements(passed.elements, encoding);
    if (!passed.withoutVr.empty()) {
        file.dataset.addMissingFrom(readElements(passed.withoutVr, DicomEncoding{false, encoding.order}));
    }
    file.pixels = std::move(passed.pixels);
    file.damage = std::move(passed.damage);
    return file;
}

}   // namespace angiopose::io
