#pragma once

#include "io/volume_file.h"

#include <gtest/gtest.h>
#include <cstring>
#include <string>
#include <vector>

namespace angiopose::test {

inline core::Volume readBack(const std::string& path)
{
    auto loaded = io::readVolume(path);
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message.text());
    return loaded ? std::move(loaded).value().volume : core::Volume{};
}

template <class T>
std::string bytesOf(const std::vector<T>& values)
{
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline std::string metaImage(const std::string& type, const std::string& voxels, const std::string& more = "")
{
    return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n" + more + "ElementType = " + type +
           "\nElementDataFile = LOCAL\n" + voxels;
}

inline void expectRefused(const std::string& path, const std::string& reason)
{
    const auto loaded = io::readVolume(path);
    ASSERT_FALSE(loaded) << path;
    EXPECT_NE(loaded.error().message.text().find(reason), std::string::npos) << loaded.error().message;
    EXPECT_TRUE(loaded.error().message.text().starts_with(path)) << loaded.error().message;
}

}   // namespace angiopose::test
