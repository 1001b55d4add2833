#include "io/angiogram_file.h"
#include "io/archive/store/sendable_file.h"
#include "io/deidentify_file.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/dicom/source_image.h"
#include "io/study/study_file.h"
#include "io/subtraction_file.h"
#include "tests/fuzz/input_file.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace angiopose;

namespace {

bool isSameImage(const core::ImageF& a, const core::ImageF& b)
{
    return a.width == b.width && a.height == b.height && a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

bool areSameImages(const core::Angiogram& a, const core::Angiogram& b)
{
    return a.frames.size() == b.frames.size() &&
           std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), isSameImage);
}

/// Checks that a de-identified object shows the same images as before, except for reported changes: colors, damaged
/// frames.
void checkFreed(const std::string& path, const std::string& nameless, const core::Messages& reported)
{
    const auto before = io::readAngiogram(path);
    if (!before) {
        return;
    }
    const auto after = io::readAngiogram(nameless);
    if (!after || (reported.empty() && !areSameImages(before.value(), after.value()))) {
        std::abort();
    }
}

}   // namespace

// Fuzzes listing, sending, referencing and de-identifying DICOM objects.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view content = fuzz::viewOf(data, size);
    const std::string path = fuzz::inputFile("object.dcm", content);
    (void)io::readStudyFile(path);
    (void)io::readSendableFile(path);
    (void)io::readSourceImage(path);
    (void)io::readSubtractionPlan(path);
    (void)io::readSpatialRegistration(content, path);
    static const io::Pseudonyms pseudonyms("key");
    const std::string nameless = (fuzz::folder() / "nameless.dcm").string();
    std::filesystem::remove(nameless);
    if (const auto freed = io::deidentifyFile(path, nameless, {}, pseudonyms)) {
        checkFreed(path, nameless, freed.value());
    }
    return 0;
}
