#pragma once

#include "io/case/case_file.h"
#include "io/image_file.h"
#include "tests/support/matchers.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace angiopose::test {

/// A folder with a small tree, a small image and the text of a minimal case.
class SmallCase {
public:
    SmallCase()
    {
        folder_.write("in/tree.csv", "x,y,z,branch\n0,0,0,1\n10,0,0,1\n20,1,0,1\n10,0,0,2\n10,8,0,2\n");
        core::ColorImage picture{16, 12, std::vector<std::uint8_t>(16 * 12 * 3, 90)};
        picture.rgb[100] = 10;
        EXPECT_TRUE(io::writePng(picture, folder_.file("in/image.png")));
    }

    nlohmann::json json() const
    {
        return nlohmann::json::parse(R"({
            "format": "angiopose-case", "version": 1,
            "vessel": { "centerline": { "path": "in/tree.csv" } },
            "angiogram": { "image": { "path": "in/image.png" }, "frame": 0 },
            "geometry": { "camera": { "fx": -2000, "fy": 2000, "cx": 7.5, "cy": 5.5, "width": 16, "height": 12 } },
            "pose": { "initial": { "cameraFromPatient": [[1,0,0,0],[0,1,0,0],[0,0,1,740],[0,0,0,1]] } } })");
    }

    std::string write(const nlohmann::json& json) const { return folder_.write("case.angiopose", json.dump()); }
    std::string path(const std::string& name) const { return folder_.file(name); }
    const TemporaryFolder& folder() const { return folder_; }

    core::Result<core::Case> load(const nlohmann::json& json)
    {
        warnings.clear();
        return io::loadCase(write(json), warnings);
    }

    std::string errorOf(const nlohmann::json& json)
    {
        const auto loaded = load(json);
        return loaded ? "loaded" : loaded.error().message.text();
    }

    core::Messages warnings;

private:
    TemporaryFolder folder_;
};

inline bool anyContains(const core::Messages& messages, const std::string& part)
{
    return std::any_of(messages.begin(), messages.end(),
                       [&](const core::Message& message) { return contains(message.text(), part); });
}

inline core::Case loadedFrom(const std::string& path, core::Messages& warnings)
{
    auto loaded = io::loadCase(path, warnings);
    EXPECT_TRUE(loaded) << loaded.error().message;
    return loaded ? std::move(loaded).value() : core::Case{};
}

/// The case of a phantom view; requires the test data.
inline core::Case phantomCase(int view)
{
    core::Messages warnings;
    const auto path = dataFile("coronary-phantom-xa/cases/IM" + std::to_string(view) + ".angiopose");
    return loadedFrom(path.string(), warnings);
}

}   // namespace angiopose::test
