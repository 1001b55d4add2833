#include "io/angiogram_file.h"
#include "io/dicom/dicom_file.h"
#include "io/vessel_input_file.h"
#include "tests/io/volume/volume_bytes.h"
#include "tests/mutants/mutate.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>

using namespace angiopose;

namespace {

long peakKilobytes()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

/// A NIfTI file with the header of `side`³ floats and `bytes` zeros.
std::string niftiOf(std::int16_t side, std::size_t bytes)
{
    std::string content(352 + bytes, '\0');
    const auto put = [&](std::size_t at, auto value) { std::memcpy(content.data() + at, &value, sizeof value); };
    put(0, std::int32_t{348});
    for (const std::size_t axis : {1U, 2U, 3U}) {
        put(40 + 2 * axis, side);
        put(76 + 4 * axis, 0.5F);
    }
    put(40, std::int16_t{3});
    put(70, std::int16_t{16});
    put(72, std::int16_t{32});
    put(108, 352.0F);
    content.replace(344, 4, std::string("n+1\0", 4));
    return content;
}

TEST(PackedVolume, ThatHoldsLessThanItSaysIsNotUnpacked)
{
    const test::TemporaryFolder folder;
    // 240 MB of zeros compress to less than a thousandth, the ratio that a header may claim; this one claims 20 MB
    // more.
    const std::string path = folder.write("lie.nii.gz", test::gzipped(niftiOf(402, std::size_t{240} << 20)));
    const long before = peakKilobytes();
    core::VesselInput input;
    input.kind = core::VesselInputKind::Volume;
    const auto vessels = io::readVessels(path, input);
    ASSERT_FALSE(vessels);
    EXPECT_EQ(vessels.error().message.id(), "volume.packing-damaged");
    EXPECT_FALSE(io::readVolume(path));
    EXPECT_FALSE(io::readLabels(path));
    EXPECT_LT(peakKilobytes() - before, 60'000);
}

TEST(PackedVolume, IsNoDicomToBeUnpackedForALook)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("scan.gz", test::gzipped(std::string(std::size_t{200} << 20, '\1')));
    const long before = peakKilobytes();
    EXPECT_FALSE(io::isDicomFile(path));
    EXPECT_FALSE(io::openDicom(path));
    EXPECT_FALSE(io::readAngiogram(path));
    EXPECT_LT(peakKilobytes() - before, 60'000);
}

TEST(PackedVolume, OfSeveralArchivesInARowIsReadWhole)
{
    const test::TemporaryFolder folder;
    const std::string content = niftiOf(16, std::size_t{4} * 16 * 16 * 16);
    const std::string packed = test::gzipped(content.substr(0, 5000)) + test::gzipped(content.substr(5000, 9000)) +
                               test::gzipped(content.substr(14'000));
    EXPECT_TRUE(io::readVolume(folder.write("parallel.nii.gz", packed)));
    EXPECT_TRUE(io::readVolume(folder.write("whole.nii.gz", test::gzipped(content))));
}

}   // namespace
