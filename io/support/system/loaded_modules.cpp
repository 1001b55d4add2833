#include "io/support/system/loaded_modules.h"

#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cstring>

namespace angiopose::io {
namespace {

std::uintptr_t hexadecimalAt(const char*& at)
{
    std::uintptr_t value = 0;
    for (;; ++at) {
        const char c = *at;
        const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) {
            return value;
        }
        value = value * 16 + static_cast<std::uintptr_t>(digit);
    }
}

/// A file of a module, mapped for as long as its symbols are looked through.
class MappedModule {
public:
    explicit MappedModule(const char* path)
    {
        const int file = ::open(path, O_RDONLY | O_CLOEXEC);
        struct stat status {};
        if (file >= 0 && ::fstat(file, &status) == 0 && status.st_size > 0) {
            size_ = static_cast<std::size_t>(status.st_size);
            void* const mapping = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
            bytes_ = mapping == MAP_FAILED ? nullptr : static_cast<const char*>(mapping);
        }
        if (file >= 0) {
            ::close(file);
        }
    }
    ~MappedModule()
    {
        if (bytes_ != nullptr) {
            ::munmap(const_cast<char*>(bytes_), size_);
        }
    }
    MappedModule(const MappedModule&) = delete;
    MappedModule& operator=(const MappedModule&) = delete;

    /// `count` of a kind at an offset; null where they are not all there.
    template <class T>
    const T* at(std::size_t offset, std::size_t count = 1) const
    {
        const bool isThere = bytes_ != nullptr && offset <= size_ && count <= (size_ - offset) / sizeof(T);
        return isThere ? reinterpret_cast<const T*>(bytes_ + offset) : nullptr;
    }

private:
    const char* bytes_ = nullptr;
    std::size_t size_ = 0;
};

struct SymbolTable {
    const ElfW(Sym) * symbols = nullptr;
    std::size_t count = 0;
    const char* names = nullptr;
    std::size_t nameBytes = 0;
};

SymbolTable tableOf(const MappedModule& file, unsigned type)
{
    const auto* header = file.at<ElfW(Ehdr)>(0);
    const bool isElf = header != nullptr && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0;
    const auto* sections = isElf ? file.at<ElfW(Shdr)>(header->e_shoff, header->e_shnum) : nullptr;
    for (std::size_t i = 0; sections != nullptr && i < header->e_shnum; ++i) {
        const auto& section = sections[i];
        if (section.sh_type == type && section.sh_link < header->e_shnum) {
            const auto& names = sections[section.sh_link];
            const std::size_t count = section.sh_size / sizeof(ElfW(Sym));
            return {file.at<ElfW(Sym)>(section.sh_offset, count), count, file.at<char>(names.sh_offset, names.sh_size),
                    names.sh_size};
        }
    }
    return {};
}

const char* functionIn(const SymbolTable& table, std::uintptr_t offset)
{
    for (std::size_t i = 0; table.symbols != nullptr && table.names != nullptr && i < table.count; ++i) {
        const auto& symbol = table.symbols[i];
        const bool isFunction = (symbol.st_info & 0xf) == STT_FUNC && symbol.st_name < table.nameBytes;
        if (isFunction && offset >= symbol.st_value && offset - symbol.st_value < symbol.st_size) {
            return table.names + symbol.st_name;
        }
    }
    return nullptr;
}

}   // namespace

void LoadedModules::read()
{
    const int file = ::open("/proc/self/maps", O_RDONLY | O_CLOEXEC);
    std::array<char, 1024> line{};
    std::size_t size = 0;
    for (std::array<char, 4096> piece{}; file >= 0;) {
        const ssize_t got = ::read(file, piece.data(), piece.size());
        if (got <= 0) {
            break;
        }
        for (ssize_t i = 0; i < got; ++i) {
            const char c = piece[static_cast<std::size_t>(i)];
            if (c != '\n') {
                line[size] = c;
                size = std::min(size + 1, line.size() - 1);
                continue;
            }
            line[size] = '\0';
            takeLine(line.data());
            size = 0;
        }
    }
    if (file >= 0) {
        ::close(file);
    }
}

/// "begin-end rights offset device inode path"; a module's parts follow each other.
void LoadedModules::takeLine(char* line)
{
    const char* path = std::strchr(line, '/');
    const char* at = line;
    const std::uintptr_t begin = hexadecimalAt(at);
    const std::uintptr_t end = *at == '-' ? hexadecimalAt(++at) : 0;
    if (path == nullptr || end == 0) {
        return;
    }
    if (count_ > 0 && std::strcmp(modules_[count_ - 1].path, path) == 0) {
        modules_[count_ - 1].end = end;
        return;
    }
    const std::size_t length = std::strlen(path) + 1;
    if (count_ < modules_.size() && length <= paths_.size() - used_) {
        char* const kept = paths_.data() + used_;
        std::memcpy(kept, path, length);
        used_ += length;
        modules_[count_++] = {begin, end, kept};
    }
}

const LoadedModules::Module* LoadedModules::at(std::uintptr_t address) const
{
    for (std::size_t i = 0; i < count_; ++i) {
        if (address >= modules_[i].begin && address < modules_[i].end) {
            return &modules_[i];
        }
    }
    return nullptr;
}

std::string_view LoadedModules::nameOf(const Module& module)
{
    return std::strrchr(module.path, '/') + 1;
}

std::string_view functionAt(const char* modulePath, std::uintptr_t offset, std::array<char, 512>& place)
{
    const MappedModule file(modulePath);
    const char* name = functionIn(tableOf(file, SHT_SYMTAB), offset);
    name = name != nullptr ? name : functionIn(tableOf(file, SHT_DYNSYM), offset);
    const std::size_t size = name != nullptr ? ::strnlen(name, place.size()) : 0;
    std::copy_n(name, size, place.begin());
    return {place.data(), size};
}

}   // namespace angiopose::io
