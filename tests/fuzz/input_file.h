#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace angiopose::fuzz {

/// The input folder of this process, because readers require named files; created under ANGIOPOSE_FUZZ_FOLDER,
/// preferably in memory.
inline const std::filesystem::path& folder()
{
    static const std::filesystem::path place = [] {
        const char* given = std::getenv("ANGIOPOSE_FUZZ_FOLDER");
        const std::filesystem::path base = given != nullptr ? given : std::filesystem::temp_directory_path().c_str();
        const auto own = base / ("angiopose-fuzz-" + std::to_string(::getpid()));
        std::filesystem::create_directories(own);
        return own;
    }();
    return place;
}

/// Writes what is to be read; its path.
inline std::string inputFile(const std::string& name, std::string_view content)
{
    const std::string path = (folder() / name).string();
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    return path;
}

inline std::string_view viewOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), size};
}

}   // namespace angiopose::fuzz
