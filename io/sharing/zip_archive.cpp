#include "io/sharing/zip_archive.h"

#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <archive.h>
#include <archive_entry.h>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr time_t oneDate = 315'619'200;   ///< 1 January 1980, noon: the first day that ZIP can represent
constexpr std::size_t pieceBytes = std::size_t{4} << 20;

using Archive = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Entry = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

/// Destination of libarchive's output, and the status of writing it.
struct Sink {
    AtomicFile& file;
    std::optional<core::Error> failure;
};

la_ssize_t take(archive* /*zip*/, void* data, const void* bytes, std::size_t size)
{
    auto& sink = *static_cast<Sink*>(data);
    if (const auto written = sink.file.write({static_cast<const char*>(bytes), size}); !written) {
        sink.failure = written.error();
        return -1;
    }
    return static_cast<la_ssize_t>(size);
}

core::Status addFile(archive* zip, const fs::path& path, const std::string& name)
{
    const auto input = openInput(path.string());
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    const Entry entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname_utf8(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), oneDate, 0);
    bool isGood = archive_write_header(zip, entry.get()) == ARCHIVE_OK;
    for (std::size_t at = 0; isGood && at < content.size(); at += pieceBytes) {
        const std::string_view piece = content.substr(at, pieceBytes);
        isGood = archive_write_data(zip, piece.data(), piece.size()) == static_cast<la_ssize_t>(piece.size());
    }
    const char* reason = archive_error_string(zip);
    return isGood ? core::Status(core::Done{})
                  : core::Error(messages::archiveNotWritten(reason ? reason : "libarchive"));
}

std::vector<fs::path> filesBelow(const std::string& folder)
{
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

}   // namespace

core::Status writeZip(const std::string& folder, const std::string& path)
{
    auto created = AtomicFile::create(path);
    if (!created) {
        return created.error();
    }
    AtomicFile file = std::move(created).value();
    Sink sink{file, {}};
    const Archive zip(archive_write_new(), archive_write_free);
    archive_write_set_format_zip(zip.get());
    archive_write_set_bytes_in_last_block(zip.get(), 1);
    const auto failed = [&](const core::Error& error) { return sink.failure.value_or(error).about(path); };
    const char* unknown = "libarchive";
    if (archive_write_open(zip.get(), &sink, nullptr, take, nullptr) != ARCHIVE_OK) {
        return failed(core::Error(messages::archiveNotWritten(unknown)));
    }
    for (const fs::path& member : filesBelow(folder)) {
        const std::string name = member.lexically_relative(folder).generic_string();
        if (const auto added = addFile(zip.get(), member, name); !added) {
            return failed(added.error());
        }
    }
    if (archive_write_close(zip.get()) != ARCHIVE_OK) {
        return failed(core::Error(messages::archiveNotWritten(unknown)));
    }
    return file.commit();
}

}   // namespace angiopose::io
