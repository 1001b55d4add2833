#include "io/angiogram_file.h"
#include "io/series/dicom_segmentation.h"
#include "io/series/slice_record.h"
#include "io/study/dicom_directory.h"
#include "tests/fuzz/input_file.h"

using namespace angiopose;

// Fuzzes DICOM data sets with pixels, read as a run, as slices, as a segmentation and as a DICOMDIR.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string path = fuzz::inputFile("image.dcm", fuzz::viewOf(data, size));
    (void)io::readAngiogram(path);
    (void)io::readSliceRecords(path);
    if (io::isDicomSegmentation(path)) {
        (void)io::listSegments(path);
    }
    (void)io::readDicomDirectory(path);
    return 0;
}
