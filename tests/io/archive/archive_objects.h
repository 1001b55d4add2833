#pragma once

#include "io/archive/archive.h"
#include "io/dicom/dicom_item.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <chrono>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace angiopose::test {

inline constexpr const char* studyUid = "2.25.4711";

/// A DICOM object with a run, written by this program's element writer with the given UIDs: number `index` of the
/// series.
inline std::string objectText(int index, const std::string& seriesUid, int side = 64, int frames = 1)
{
    std::vector<std::uint16_t> pixels;
    for (int frame = 0; frame < frames; ++frame) {
        for (int i = 0; i < side * side; ++i) {
            pixels.push_back(static_cast<std::uint16_t>((i * 31 + index * 977 + frame * 13) % 4096));
        }
    }
    io::DicomObject object;
    io::DicomItem root = object.root();
    for (const auto& [tag, vr, value] : std::vector<std::tuple<io::DicomTag, const char*, std::string>>{
             {0x00080005, "CS", "ISO_IR 192"},
             {0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.12.1"},
             {0x00080018, "UI", seriesUid + "." + std::to_string(index + 1)},
             {0x00080020, "DA", "20240305"},
             {0x00080030, "TM", ""},
             {0x00080050, "SH", ""},
             {0x00080060, "CS", "XA"},
             {0x00080090, "PN", ""},
             {0x00100010, "PN", "Müller^Änne"},
             {0x00100020, "LO", "P-4711"},
             {0x0020000d, "UI", studyUid},
             {0x0020000e, "UI", seriesUid},
             {0x00200013, "IS", std::to_string(index + 1)},
             {0x00280004, "CS", "MONOCHROME2"},
             {0x00280008, "IS", std::to_string(frames)}}) {
        root.text(tag, vr, value);
    }
    for (const auto& [tag, value] : std::vector<std::pair<io::DicomTag, int>>{{0x00280002, 1},
                                                                              {0x00280010, side},
                                                                              {0x00280011, side},
                                                                              {0x00280100, 16},
                                                                              {0x00280101, 16},
                                                                              {0x00280102, 15},
                                                                              {0x00280103, 0}}) {
        root.setUnsignedShort(tag, value);
    }
    root.words(0x7fe00010, pixels);
    const auto text = object.content();
    EXPECT_TRUE(text) << text.error().message.text();
    return text ? text.value() : std::string();
}

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

/// Names of all files below a folder that are incomplete objects; there must never be any.
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

inline io::ObjectStore openStore(const std::string& folder, std::uint64_t maxObjectBytes = 1u << 30)
{
    auto opened = io::ObjectStore::open(folder, maxObjectBytes);
    EXPECT_TRUE(opened);
    return std::move(opened).value();
}

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count(); }

private:
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Expects the node's name, the problem and a remedy in the message, within ten seconds.
inline void expectFailure(const core::Error& error, const core::MessageEntry& expected, const Stopwatch& watch)
{
    EXPECT_TRUE(error.message.is(expected)) << error.message.text();
    EXPECT_LT(watch.seconds(), 10.0);
}

}   // namespace angiopose::test
