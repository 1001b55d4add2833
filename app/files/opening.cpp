#include "app/files/opening.h"

#include "app/document/edit_case.h"
#include "app/files/open_controller.h"
#include "app/files/open_notes.h"
#include "app/files/recent_cases.h"
#include "core/case/case_views.h"
#include "io/opening/assemble_case.h"
#include "io/opening/view_from_inputs.h"

#include <memory>
#include <utility>

namespace angiopose::app {
namespace {

QStringList replaceCase(CaseDocument& document, const core::Case& wanted, const Opening& opening)
{
    const QString path = opening.inputs.wholeCase ? opening.original.value_or(opening.paths.front()) : QString();
    document.replace(wanted, path);
    if (!path.isEmpty()) {
        rememberCase(path);
    }
    if (opening.original || !opening.inputs.moved.empty()) {
        document.markUnsaved();   // the file knows less than the window
    }
    return notesOf(opening.inputs, document.current());
}

QStringList joinCase(CaseDocument& document, const core::Case& wanted, const Opening& opening)
{
    if (document.isEmpty() && document.undoStack().count() == 0) {   // else a mask painted on a scan alone would go
        document.replace(wanted, {});
    } else {
        document.push(joinInputs(
            document, wanted, [names = namesOf(opening.paths)] { return OpenController::tr("Open %1").arg(names); }));
    }
    return notesOf(opening.inputs, document.current()) + notesOnScan(opening.inputs, document.current());
}

QStringList addView(CaseDocument& document, const core::Case& wanted, const Opening& opening)
{
    const QStringList notes = notesOf(opening.inputs, core::showingView(wanted, wanted.views.size() - 1));
    document.push(std::make_unique<ChangeViews>(
        document, ChangeViews::valuesOf(wanted),
        [names = namesOf(opening.paths)] { return OpenController::tr("Add view %1").arg(names); }));
    return notes + QStringList{OpenController::tr("View added: a click in the strip above the image shows it.")};
}

}   // namespace

bool isAnotherView(const core::Case& open, const io::LoadedInputs& inputs)
{
    const bool isNew = inputs.imageFile.path != open.shown().imageFile.path;
    return inputs.angiogram && !inputs.tree && !inputs.wholeCase && open.vessels.tree && open.shown().angiogram &&
           isNew;
}

core::Result<core::Case> caseWith(const core::Case& open, const Opening& opening)
{
    const io::LoadedInputs& inputs = opening.inputs;
    if (opening.way == Opening::Way::Replace) {
        return inputs.wholeCase ? *inputs.wholeCase : io::withInputs({}, inputs);
    }
    if (opening.way == Opening::Way::Join) {
        return io::withInputs(open, inputs);
    }
    auto added = io::viewFrom(open, inputs, opening.paths.front().toStdString());
    if (!added) {
        return added.error();
    }
    core::Case wanted = open;
    wanted.views.push_back(std::move(added).value());
    return wanted;
}

core::Result<QStringList> takeIn(CaseDocument& document, const Opening& opening)
{
    const auto wanted = caseWith(document.current(), opening);
    if (!wanted) {
        return wanted.error();
    }
    switch (opening.way) {
        case Opening::Way::Replace:
            return replaceCase(document, wanted.value(), opening);
        case Opening::Way::AddView:
            return addView(document, wanted.value(), opening);
        case Opening::Way::Join:
            break;
    }
    return joinCase(document, wanted.value(), opening);
}

}   // namespace angiopose::app
