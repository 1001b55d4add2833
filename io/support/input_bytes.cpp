#include "io/support/input_bytes.h"

#include "io/support/file_error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

/// Closes the descriptor on every way out.
class Descriptor {
public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (value_ >= 0) {
            ::close(value_);
        }
    }
    int value() const { return value_; }

private:
    int value_;
};

/// Why this is no file to read; empty when it is one. Asked before opening: opening a pipe would wait for ever.
std::string findObstacle(const std::string& path)
{
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        return errno == ENOENT ? "there is no such file. Check the path."
                               : std::string("it cannot be reached (") + std::strerror(errno) + "). Check the path.";
    }
    if (S_ISDIR(status.st_mode)) {
        return "this is a folder. Choose a file in it.";
    }
    if (!S_ISREG(status.st_mode)) {
        return "this is not a regular file. Choose a file on disk.";
    }
    if (status.st_size == 0) {
        return "the file is empty. Export or copy it again.";
    }
    return {};
}

struct Signature {
    std::size_t offset;
    std::string_view bytes;
    std::string_view meaning;
};

constexpr std::array signatures = {
    Signature{0, "\x1f\x8b", "a gzip archive"},
    Signature{0, "PK\x03\x04", "a zip archive"},
    Signature{0, "NRRD000", "an NRRD volume"},
    Signature{344, "n+1", "a NIfTI volume"},
    Signature{344, "ni1", "a NIfTI header"},
    Signature{0, "\x89HDF", "an HDF5 file"},
    Signature{0, "CDF\x01", "a NetCDF (MINC) volume"},
    Signature{0, "ObjectType", "a MetaImage header"},
    Signature{0, "TRACK", "a TrackVis tractogram"},
    Signature{0, "mrtrix tracks", "an MRtrix tractogram"},
    Signature{0, "ply", "a PLY surface"},
    Signature{0, "solid", "an STL surface"},
    Signature{0, "glTF", "a glTF scene"},
    Signature{0, "%PDF", "a PDF document"},
    Signature{128, "DICM", "a DICOM file"},
    Signature{0, "\x89PNG", "a PNG image"},
    Signature{0, "\xff\xd8\xff", "a JPEG image"},
    Signature{0, {"II*\0", 4}, "a TIFF image"},
    Signature{0, {"MM\0*", 4}, "a TIFF image"},
    Signature{0, "# vtk DataFile", "a legacy VTK file"},
    Signature{0, "<?xml", "an XML file"},
    Signature{0, "<VTKFile", "a VTK XML file"},
    Signature{0, "{", "a JSON file"},
};

}   // namespace

InputBytes::InputBytes(InputBytes&& other) noexcept
    : mapping_(std::exchange(other.mapping_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      owned_(std::move(other.owned_))
{
}

InputBytes& InputBytes::operator=(InputBytes&& other) noexcept
{
    std::swap(mapping_, other.mapping_);
    std::swap(size_, other.size_);
    std::swap(owned_, other.owned_);
    return *this;
}

InputBytes::~InputBytes()
{
    if (mapping_) {
        ::munmap(const_cast<char*>(mapping_), size_);
    }
}

core::Result<InputBytes> openInput(const std::string& path)
{
    if (const std::string obstacle = findObstacle(path); !obstacle.empty()) {
        return fileError(path, obstacle);
    }
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat status {};
    if (file.value() < 0 || ::fstat(file.value(), &status) != 0) {
        return fileError(
            path, std::string("it cannot be opened (") + std::strerror(errno) + "). Check that you may read it.");
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.value(), 0);
    if (mapping == MAP_FAILED) {
        return fileError(path,
                         std::string("it cannot be read (") + std::strerror(errno) + "). Copy it to a local disk.");
    }
    InputBytes content(static_cast<const char*>(mapping), size);
    if (content.view().starts_with("version https://git-lfs.github.com/spec/")) {
        return fileError(path,
                         "this is a Git LFS pointer, not the file itself. Run `git lfs pull` where it came from.");
    }
    return content;
}

std::string extensionOf(const std::string& path)
{
    const std::filesystem::path file(path);
    std::string extension = file.extension().string();
    if (extension == ".gz") {
        extension = file.stem().extension().string() + extension;
    }
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return extension;
}

std::string_view describeContent(std::string_view content)
{
    for (const Signature& signature : signatures) {
        if (content.size() > signature.offset && content.substr(signature.offset).starts_with(signature.bytes)) {
            return signature.meaning;
        }
    }
    return {};
}

}   // namespace angiopose::io