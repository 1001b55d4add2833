#include "tests/io/volume/volume_bytes.h"
#include "tests/support/temporary_folder.h"

#include "core/support/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace angiopose;

namespace {

/// A scan of 24³ values around 100 ± 300, one of which is `stray`.
template <class T>
std::string scanWith(T stray, const std::string& type)
{
    core::CounterRandom random(7);
    std::vector<T> values(24 * 24 * 24);
    for (T& value : values) {
        value = static_cast<T>(100.0 + 300.0 * random.normal());
    }
    values[1234] = stray;
    std::string text = test::metaImage(type, test::bytesOf(values));
    return text.replace(text.find("2 2 2"), 5, "24 24 24");
}

int levelsOf(const core::Volume& volume)
{
    std::vector<std::int16_t> voxels(volume.voxels.begin(), volume.voxels.end());
    std::ranges::sort(voxels);
    return static_cast<int>(std::unique(voxels.begin(), voxels.end()) - voxels.begin());
}

TEST(StrayValues, LeaveTheOthersTheirLevels)
{
    const test::TemporaryFolder folder;
    const std::string wide = folder.write("wide.mha", scanWith<float>(3.4e38F, "MET_FLOAT"));
    const std::string padded =
        folder.write("padded.mha", scanWith<std::int32_t>(std::numeric_limits<std::int32_t>::min(), "MET_INT"));
    const std::string infinite =
        folder.write("infinite.mha", scanWith<float>(std::numeric_limits<float>::infinity(), "MET_FLOAT"));
    for (const std::string& path : {wide, padded, infinite}) {
        const auto loaded = io::readVolume(path);
        ASSERT_TRUE(loaded) << loaded.error().message;
        const core::Volume& volume = loaded.value().volume;
        EXPECT_GT(levelsOf(volume), path == padded ? 1000 : 10'000) << path;
        EXPECT_LT(std::abs(volume.slope), 1.1) << path;
        const bool isSaid = std::ranges::any_of(loaded.value().warnings, [](const core::Message& warning) {
            return warning.id() == "volume.stray-values" || warning.id() == "volume.not-numbers";
        });
        EXPECT_TRUE(isSaid) << path;
    }
}

TEST(StrayValues, AreNotSeenInMapsThatAreMostlyEmpty)
{
    const test::TemporaryFolder folder;
    std::vector<float> values(24 * 24 * 24, 0.0F);
    for (std::size_t i = 0; i < 150; ++i) {
        values[50 * i] = 0.001F * static_cast<float>(i) + 70'000.0F * static_cast<float>(i % 2);
    }
    std::string text = test::metaImage("MET_FLOAT", test::bytesOf(values));
    const auto loaded = io::readVolume(folder.write("map.mha", text.replace(text.find("2 2 2"), 5, "24 24 24")));
    ASSERT_TRUE(loaded);
    const auto highest = *std::ranges::max_element(loaded.value().volume.voxels);
    EXPECT_NEAR(loaded.value().volume.slope * highest + loaded.value().volume.intercept, 70'000.149, 1.1);
}

}   // namespace
