#include "io/label_list.h"
#include "io/volume_file.h"
#include "tests/fuzz/input_file.h"

using namespace angiopose;

// Fuzzes NIfTI, NRRD, MetaImage, GIPL and VTK images, detected by content.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string path = fuzz::inputFile("scan.nii", fuzz::viewOf(data, size));
    (void)io::isVolumeFile(path);
    (void)io::readVolume(path);
    (void)io::readLabels(path);
    (void)io::readLabelNames(path);
    return 0;
}
