#include "io/image_file.h"

#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/quiet_libraries.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace io {
namespace {

/// VTK counts rows from the bottom.
void copyFlipped(const std::uint8_t* topRowFirst, vtkImageData* image, std::size_t rowBytes, int rows)
{
    auto* destination = static_cast<std::uint8_t*>(image->GetScalarPointer());
    for (int row = 0; row < rows; ++row) {
        std::copy_n(topRowFirst + static_cast<std::size_t>(row) * rowBytes, rowBytes,
                    destination + static_cast<std::size_t>(rows - 1 - row) * rowBytes);
    }
}

core::Status writeEncoded(vtkImageData* image, const std::string& path, const std::map<std::string, std::string>& texts)
{
    quietLibraries();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    for (const auto& [key, value] : texts) {
        writer->AddText(key.c_str(), value.c_str());
    }
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    if (bytes == nullptr || bytes->GetNumberOfTuples() == 0) {
        return fileError(path, "the picture could not be encoded as PNG. Choose a smaller size.");
    }
    return writeAtomically(path, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                                  static_cast<std::size_t>(bytes->GetNumberOfTuples())});
}

}   // namespace

core::Status writePng(const core::ColorImage& image, const std::string& path,
                      const std::map<std::string, std::string>& texts)
{
    if (image.width <= 0 || image.height <= 0) {
        return fileError(path, "there is no picture to write.");
    }
    vtkNew<vtkImageData> data;
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    copyFlipped(image.rgb.data(), data, 3 * static_cast<std::size_t>(image.width), image.height);
    return writeEncoded(data, path, texts);
}

core::Status writePng(const core::Mask2d& mask, const std::string& path)
{
    if (mask.isEmpty()) {
        return fileError(path, "there is no mask to write.");
    }
    std::vector<std::uint8_t> grey(mask.pixels.size());
    std::transform(mask.pixels.begin(), mask.pixels.end(), grey.begin(),
                   [](std::uint8_t inside) { return static_cast<std::uint8_t>(inside ? 255 : 0); });
    vtkNew<vtkImageData> data;
    data->SetDimensions(mask.width, mask.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    copyFlipped(grey.data(), data, static_cast<std::size_t>(mask.width), mask.height);
    return writeEncoded(data, path, {});
}

}   // namespace io
