#include "io/support/silence_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/oflog/oflog.h>
#include <itkObject.h>
#include <nifti2_io.h>
#include <tiffio.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <mutex>

namespace angiopose::io {
namespace {

/// Discards VTK's output.
class SilentWindow : public vtkOutputWindow {
public:
    static SilentWindow* New();
    void DisplayText(const char*) override {}
};
vtkStandardNewMacro(SilentWindow)

}   // namespace

void silenceLibraries()
{
    static std::once_flag once;
    std::call_once(once, [] {
        const vtkNew<SilentWindow> window;
        vtkOutputWindow::SetInstance(window);
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);   // errors reach the logger before the output window
        itk::Object::SetGlobalWarningDisplay(false);
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        nifti_set_debug_level(0);
        TIFFSetWarningHandler(nullptr);
        TIFFSetErrorHandler(nullptr);
    });
}

}   // namespace angiopose::io
