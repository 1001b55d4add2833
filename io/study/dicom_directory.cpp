#include "io/study/dicom_directory.h"

#include "io/dicom/dicom_text.h"
#include "io/dicom/element_filter.h"
#include "io/messages/messages.h"
#include "io/study/file_start.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <map>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::size_t maxDirectoryBytes = std::size_t{64} << 20;
constexpr std::size_t bodyAt = 132;   // offset of the data after preamble and magic bytes
constexpr int maxNesting = 16;
constexpr std::uint32_t openLength = 0xffffffff;
constexpr DicomTag itemTag = 0xfffee000;
constexpr DicomTag itemEndTag = 0xfffee00d;
constexpr DicomTag sequenceEndTag = 0xfffee0dd;
constexpr DicomTag firstRecordTag = 0x00041200;
constexpr DicomTag recordsTag = 0x00041220;
constexpr DicomTag nextRecordTag = 0x00041400;
constexpr DicomTag inUseTag = 0x00041410;
constexpr DicomTag lowerRecordTag = 0x00041420;
constexpr DicomTag fileTag = 0x00041500;
constexpr DicomEncoding encoding;   // a DICOMDIR is always explicit VR little endian

struct Record {
    DicomDataset data;
    std::size_t next = 0, lower = 0;   ///< byte offsets from the start of the file; 0 if there is no such record
    bool isInUse = true;
};

using Records = std::map<std::size_t, Record>;   // records, keyed by the offset at which they start

/// Returns the offset after the delimiter `end` that closes the elements starting at `at`; nullopt if it is missing.
std::optional<std::size_t> closedAt(std::string_view bytes, std::size_t at, DicomTag end, int depth)
{
    while (const auto head = at <= bytes.size() ? readElementHeader(bytes.substr(at), encoding) : std::nullopt) {
        at += head->size;
        if (head->tag == end) {
            return at;
        }
        if (head->length != openLength) {
            at += head->length;
            continue;
        }
        const auto inner = depth < maxNesting
                               ? closedAt(bytes, at, head->tag == itemTag ? itemEndTag : sequenceEndTag, depth + 1)
                               : std::nullopt;
        if (!inner) {
            return std::nullopt;
        }
        at = *inner;
    }
    return std::nullopt;
}

std::size_t placeIn(const DicomDataset& data, DicomTag tag)
{
    const auto place = data.number(tag);
    return place && *place > 0.0 ? static_cast<std::size_t>(*place) : 0;
}

Record recordOf(std::string_view elements)
{
    Record record;
    record.data = readElements(filterElements(elements, encoding).elements, encoding);
    record.next = placeIn(record.data, nextRecordTag);
    record.lower = placeIn(record.data, lowerRecordTag);
    record.isInUse = record.data.integer(inUseTag).value_or(0xffff) != 0;
    return record;
}

/// Returns the items of the record sequence that starts at `at`.
std::optional<Records> recordsIn(std::string_view bytes, std::size_t at, std::uint32_t length)
{
    Records records;
    const std::size_t end = length == openLength ? bytes.size() : at + length;
    if (end > bytes.size()) {
        return std::nullopt;
    }
    while (at < end) {
        const auto head = readElementHeader(bytes.substr(at), encoding);
        if (head && head->tag == sequenceEndTag && length == openLength) {
            return records;
        }
        if (!head || head->tag != itemTag) {
            return std::nullopt;
        }
        const std::size_t begin = at + head->size;
        const auto closed =
            head->length == openLength ? closedAt(bytes, begin, itemEndTag, 0) : std::optional(begin + head->length);
        if (!closed || *closed > end) {
            return std::nullopt;
        }
        records.emplace(at, recordOf(bytes.substr(begin, *closed - begin)));
        at = *closed;
    }
    return length == openLength ? std::nullopt : std::optional(records);
}

/// Returns the file to which a record and its parent records refer.
DirectoryEntry listedFile(const DicomDataset& data)
{
    DirectoryEntry file;
    for (std::size_t i = 0;; ++i) {
        const std::string_view part = data.text(fileTag, i);
        if (part.empty()) {
            break;
        }
        file.name += (i == 0 ? "" : "/") + std::string(part);
    }
    file.identity = identityOf(data);
    file.studyDescription = utf8Text(data, 0x00081030);
    file.seriesDescription = utf8Text(data, 0x0008103e);
    file.seriesNumber = data.integer(0x00200011).value_or(0);
    return file;
}

/// Follows the links from the first record; returns nullopt if a record is missing, visited twice or never reached.
std::optional<std::vector<DirectoryEntry>> follow(const Records& records, std::size_t first)
{
    struct Step {
        std::size_t place;
        DicomDataset above;
    };
    std::vector<DirectoryEntry> files;
    std::map<std::size_t, bool> met;
    std::vector<Step> steps;
    if (first != 0) {
        steps.push_back({first, {}});
    }
    while (!steps.empty()) {
        const Step step = std::move(steps.back());
        steps.pop_back();
        const auto found = records.find(step.place);
        if (found == records.end() || !met.emplace(step.place, true).second) {
            return std::nullopt;
        }
        const Record& record = found->second;
        DicomDataset data = record.data;
        data.addMissingFrom(step.above);
        if (record.isInUse && record.data.has(fileTag)) {
            files.push_back(listedFile(data));
        }
        if (record.next != 0) {
            steps.push_back({record.next, step.above});
        }
        if (record.lower != 0 && record.isInUse) {
            steps.push_back({record.lower, data});
        }
    }
    const bool isAllMet = std::ranges::all_of(
        records, [&met](const auto& each) { return !each.second.isInUse || met.contains(each.first); });
    return isAllMet ? std::optional(files) : std::nullopt;
}

}   // namespace

core::Result<std::vector<DirectoryEntry>> readDicomDirectory(const std::string& path)
{
    const auto read = readFileStart(path, maxDirectoryBytes);
    if (!read) {
        return read.error();
    }
    const std::string_view bytes = read.value().bytes;
    if (bytes.size() <= bodyAt || bytes.substr(bodyAt - 4, 4) != "DICM") {
        return fileError(path, messages::dicomNotOne());
    }
    std::size_t first = 0;
    for (std::size_t at = bodyAt; at < bytes.size();) {
        const auto head = readElementHeader(bytes.substr(at), encoding);
        if (!head) {
            break;
        }
        at += head->size;
        if (head->tag == recordsTag) {
            const auto records = recordsIn(bytes, at, head->length);
            auto files = records ? follow(*records, first) : std::nullopt;
            if (!files) {
                return fileError(path, records ? messages::directoryTorn() : messages::directoryUnfinished());
            }
            return *std::move(files);
        }
        if (head->tag == firstRecordTag && head->length == 4 && at + 4 <= bytes.size()) {
            first = readUint32(bytes.substr(at), ByteOrder::Little);
        }
        if (head->length > bytes.size() - at) {
            break;
        }
        at += head->length;
    }
    return fileError(path, messages::directoryNoRecords());
}

std::string normalizedFileName(std::string name)
{
    std::ranges::transform(name, name.begin(),
                           [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    if (const auto version = name.find(";1"); version != std::string::npos) {
        name.erase(version);
    }
    if (name.ends_with('.')) {
        name.pop_back();
    }
    return name;
}

}   // namespace angiopose::io
