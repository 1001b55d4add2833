#pragma once

#include "core/imaging/angiogram.h"
#include "io/archive/archive.h"
#include "io/dicom/write_dicom.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <chrono>
#include <string>
#include <vector>

namespace angiopose::test {

inline constexpr const char* studyUid = "2.25.4711";

/// An angiogram by this program's own writer: number `index` of a series.
inline std::string objectText(int index, const std::string& seriesUid, int side = 64, int frames = 1)
{
    core::Angiogram run;
    for (int frame = 0; frame < frames; ++frame) {
        core::ImageF image(side, side);
        for (int i = 0; i < side * side; ++i) {
            image.pixels[static_cast<std::size_t>(i)] = static_cast<float>((i * 31 + index * 977 + frame * 13) % 4096);
        }
        run.frames.push_back(std::move(image));
    }
    run.identity.patientName = "Müller^Änne";
    run.identity.patientId = "P-4711";
    run.identity.studyUid = studyUid;
    run.identity.studyDate = "2024-03-05";
    run.identity.seriesUid = seriesUid;
    run.identity.sopInstanceUid = seriesUid + "." + std::to_string(index + 1);
    run.identity.modality = "XA";
    const auto text = io::dicomText(run);
    EXPECT_TRUE(text) << text.error().message.text();
    return text ? text.value() : std::string();
}

/// `count` of them as files.
inline std::vector<std::string> writeObjects(const TemporaryFolder& folder, const std::string& seriesUid, int count,
                                             int side = 64)
{
    std::vector<std::string> files;
    for (int i = 0; i < count; ++i) {
        files.push_back(
            folder.write("sent/" + seriesUid + "." + std::to_string(i + 1) + ".dcm", objectText(i, seriesUid, side)));
    }
    return files;
}

/// Names of all files below a folder that are no whole objects: what must never be left.
inline std::vector<std::string> halfFiles(const std::string& folder)
{
    std::vector<std::string> found;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder)) {
        if (each.is_regular_file() && each.path().extension() != ".dcm" && each.path().filename() != ".begun") {
            found.push_back(each.path().string());
        }
    }
    return found;
}

inline io::ObjectStore openStore(const std::string& folder, std::uint64_t mostObjectBytes = 1u << 30)
{
    auto opened = io::ObjectStore::open(folder, mostObjectBytes);
    EXPECT_TRUE(opened);
    return std::move(opened).value();
}

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count(); }

private:
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// The node's name, the problem and a remedy, in no more than ten seconds.
inline void expectFailure(const core::Error& error, const core::MessageEntry& expected, const Stopwatch& watch)
{
    EXPECT_TRUE(error.message.is(expected)) << error.message.text();
    EXPECT_LT(watch.seconds(), 10.0);
}

}   // namespace angiopose::test
