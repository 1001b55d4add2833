#include "io/vessel/vtp_text.h"

#include "io/support/silence_libraries.h"
#include "io/vessel/line_set.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>
#include <algorithm>
#include <limits>

namespace angiopose::io {
namespace {

void addPointsAndLines(const core::VesselTree& tree, vtkPolyData* data)
{
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkCellArray> lines;
    const vtkNew<vtkDoubleArray> radius;
    radius->SetName("Radius");
    for (const core::VesselBranch& branch : tree.branches) {
        lines->InsertNextCell(static_cast<int>(branch.pointsInPatient.size()));
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            lines->InsertCellPoint(points->InsertNextPoint(branch.pointsInPatient[i].data()));
            radius->InsertNextValue(branch.radiusMm.empty() ? std::numeric_limits<double>::quiet_NaN()
                                                            : branch.radiusMm[i]);
        }
    }
    data->SetPoints(points);
    data->SetLines(lines);
    const bool hasRadius = std::any_of(tree.branches.begin(), tree.branches.end(),
                                       [](const core::VesselBranch& branch) { return !branch.radiusMm.empty(); });
    if (hasRadius) {
        data->GetPointData()->AddArray(radius);
    }
}

void addLabels(const core::VesselTree& tree, vtkPolyData* data)
{
    const vtkNew<vtkIntArray> ids;
    ids->SetName("GroupIds");
    const vtkNew<vtkStringArray> names;
    names->SetName("Name");
    for (const core::VesselBranch& branch : tree.branches) {
        ids->InsertNextValue(branch.id);
        names->InsertNextValue(sanitizedBranchName(branch.name));
    }
    data->GetCellData()->AddArray(ids);
    data->GetCellData()->AddArray(names);
    const vtkNew<vtkStringArray> axes;
    axes->SetName("SPACE");
    axes->InsertNextValue("LPS");
    data->GetFieldData()->AddArray(axes);
}

}   // namespace

std::string vtpText(const core::VesselTree& tree)
{
    silenceLibraries();
    const vtkNew<vtkPolyData> data;
    addPointsAndLines(tree, data);
    addLabels(tree, data);
    const vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetDataModeToBinary();
    writer->SetCompressorTypeToNone();
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
}

}   // namespace angiopose::io
