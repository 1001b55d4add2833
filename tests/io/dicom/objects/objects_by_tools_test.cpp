#include "tests/io/dicom/objects/made_objects.h"

#include <array>
#include <cstdio>
#include <cstdlib>

using namespace angiopose;

namespace {

using test::MadeObjects;

struct ToolOutcome {
    int status = -1;
    std::string output;
};

ToolOutcome outcomeOf(const std::string& command)
{
    ToolOutcome outcome;
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
        outcome.output += buffer.data();
    }
    outcome.status = pipe != nullptr ? ::pclose(pipe) : -1;
    return outcome;
}

bool isThere(const std::string& command)
{
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

/// Lines with "Error" from the validator of dicom3tools, which knows the required attributes of each IOD.
std::string errorsIn(const std::string& output)
{
    std::string errors;
    for (std::size_t at = 0; at < output.size();) {
        const std::size_t end = std::min(output.find('\n', at), output.size());
        const std::string line = output.substr(at, end - at);
        if (line.find("Error") != std::string::npos) {
            errors += line + "\n";
        }
        at = end + 1;
    }
    return errors;
}

TEST_F(MadeObjects, AreFreeOfErrorsByDciodvfy)
{
    if (!isThere("command -v dciodvfy")) {
        GTEST_SKIP() << "dciodvfy is absent: install dicom3tools";
    }
    const auto check = [this](const std::string& of) {
        for (const auto& [name, object] : all()) {
            if (of != "of a picture" || name != "state") {
                const ToolOutcome outcome = outcomeOf("dciodvfy -new " + written(name, object));
                EXPECT_EQ(errorsIn(outcome.output), "") << name << " " << of;
                EXPECT_NE(outcome.output.size(), 0U) << name;
            }
        }
    };
    check("of a run");
    angiogram.laterality.clear();
    scan.source.laterality = "R";
    check("of another side");
    folder.write("plain.png", "\x89PNG\r\n\x1a\n no image");
    angiogram = scan.source = source(folder.file("plain.png"));
    scan.slices.clear();
    check("of a picture");
    EXPECT_EQ(errorsIn(outcomeOf("dciodvfy -new " + folder.file("run.dcm")).output), "") << "converted run";
}

/// Reads every element as the standard's dictionary has it, warnings as errors.
TEST_F(MadeObjects, AreReadByPydicom)
{
    if (!isThere("/usr/bin/python3 -c 'import pydicom, numpy'")) {
        GTEST_SKIP() << "pydicom is absent: install python3-pydicom";
    }
    folder.write(
        "check.py",
        "import sys, warnings\n"
        "warnings.simplefilter('error')\n"
        "import pydicom\n"
        "pydicom.config.settings.reading_validation_mode = pydicom.config.RAISE\n"
        "for path in sys.argv[1:]:\n"
        "    data = pydicom.dcmread(path)\n"
        "    count = sum(1 for element in data.iterall() if element.value is not None)\n"
        "    assert count > 20, path\n"
        "    if 'PixelData' in data:\n"
        "        print(path.split('/')[-1], data.pixel_array.shape, int(data.pixel_array.astype('u4').sum()))\n");
    std::string paths;
    for (const auto& [name, object] : all()) {
        paths += " " + written(name, object);
    }
    const ToolOutcome outcome = outcomeOf("/usr/bin/python3 " + folder.file("check.py") + paths);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    unsigned sum = 0;
    const core::ColorImage picture = images(1).images.front();
    for (const std::uint8_t level : picture.rgb) {
        sum += level;
    }
    EXPECT_NE(outcome.output.find("picture-object.dcm (15, 21, 3) " + std::to_string(sum)), std::string::npos)
        << outcome.output;
    const core::VoxelMask mask = vessels();
    const auto marked = std::count(mask.voxels.begin(), mask.voxels.end(), 1);
    EXPECT_NE(outcome.output.find("segmentation-object.dcm (5, 9, 8) " + std::to_string(marked)), std::string::npos)
        << outcome.output;
}

}   // namespace
