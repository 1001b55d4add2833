#include "app/decode/vtk_reading.h"

#include "app/decode/helper_session.h"

#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace angiopose::decode {
namespace {

/// Output window that receives all VTK errors and warnings, including those not sent to the observers of a reader.
class ErrorOutputWindow : public vtkOutputWindow {
public:
    static ErrorOutputWindow* New();
    void DisplayText(const char*) override
    {
        std::_Exit(writeReply([this] { return io::DecoderReply{io::ReplyKind::Refusal, place()}; }));
    }
    std::function<std::string()> place;
};
vtkStandardNewMacro(ErrorOutputWindow)

    class Progress : public vtkCommand {
public:
    static Progress* New() { return new Progress; }
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
        writeProgress(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
    }
};

}   // namespace

std::string readWholeFile(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::string content(std::filesystem::file_size(path), '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    return content;
}

void readOrThrow(vtkAlgorithm& reader, const std::function<std::string()>& place)
{
    const vtkNew<ErrorOutputWindow> window;
    window->place = place;
    vtkOutputWindow::SetInstance(window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    const vtkNew<Progress> progress;
    reader.AddObserver(vtkCommand::ProgressEvent, progress);
    reader.Update();
    if (reader.GetErrorCode() != 0) {
        window->DisplayText("");
    }
}

}   // namespace angiopose::decode
