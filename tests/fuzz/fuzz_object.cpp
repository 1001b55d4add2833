#include "io/angiogram_file.h"
#include "io/archive/store/sendable_file.h"
#include "io/deidentify_file.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/dicom/source_image.h"
#include "io/study/study_file.h"
#include "io/subtraction_file.h"
#include "tests/fuzz/input_file.h"

#include <cstdlib>

using namespace angiopose;

// DICOM objects as they are listed, sent, referred to and freed of identity. What was freed of identity is read again.
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
    if (io::deidentifyFile(path, nameless, {}, pseudonyms) && io::readAngiogram(path) && !io::readAngiogram(nameless)) {
        std::abort();
    }
    return 0;
}
