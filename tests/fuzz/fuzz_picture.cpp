#include "io/angiogram_file.h"
#include "tests/fuzz/input_file.h"

using namespace angiopose;

// Fuzzes PNG, JPEG and TIFF, detected by content.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view content = fuzz::viewOf(data, size);
    if (content.substr(0, 132).find("DICM") == std::string_view::npos) {   // belongs to another harness
        (void)io::readAngiogram(fuzz::inputFile("image.png", content));
    }
    return 0;
}
