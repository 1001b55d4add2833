// Keys of EditCurvesTool: switch the edit mode, change the brush size, and add or remove points of the current path.
#include "ui/views/angiogram_view.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <QKeyEvent>

#include <algorithm>
#include <array>

namespace angiopose::ui {
namespace {

constexpr double brushStep = 1.25;

struct EditKey {
    Qt::Key key;
    CurveEdit edit;
};
constexpr std::array editKeys{EditKey{Qt::Key_E, CurveEdit::Erase},      EditKey{Qt::Key_D, CurveEdit::Draw},
                              EditKey{Qt::Key_C, CurveEdit::Cut},        EditKey{Qt::Key_X, CurveEdit::Remove},
                              EditKey{Qt::Key_W, CurveEdit::MarkDevice}, EditKey{Qt::Key_B, CurveEdit::Box},
                              EditKey{Qt::Key_L, CurveEdit::Lasso}};

std::optional<CurveEdit> editOf(const QKeyEvent& event)
{
    const auto* match =
        std::ranges::find(editKeys, event.key(), [](const EditKey& row) { return static_cast<int>(row.key); });
    const bool isPlain = event.modifiers() == Qt::NoModifier;
    return isPlain && match != editKeys.end() ? std::optional(match->edit) : std::nullopt;
}

}   // namespace

bool EditCurvesTool::takesKey(const QKeyEvent& event) const
{
    const bool isBrush = edit_ == CurveEdit::Erase && event.modifiers() == Qt::NoModifier &&
                         (event.key() == Qt::Key_BracketLeft || event.key() == Qt::Key_BracketRight);
    const bool isPath = !path_.isEmpty() && (event.key() == Qt::Key_Backspace || event.key() == Qt::Key_Return ||
                                             event.key() == Qt::Key_Enter);
    // In this mode, Backspace always edits the path, even if there is none; otherwise, it would move the pose.
    return isBrush || isPath || isSuspectKey(event) || event.key() == Qt::Key_Backspace || editOf(event).has_value();
}

void EditCurvesTool::keyPress(const QKeyEvent& event)
{
    if (isSuspectKey(event)) {
        suspectKey(event);
    } else if (const auto chosen = editOf(event)) {
        setEdit(*chosen);
    } else if (event.key() == Qt::Key_BracketLeft || event.key() == Qt::Key_BracketRight) {
        setBrush(brushRadius_ * (event.key() == Qt::Key_BracketLeft ? 1.0 / brushStep : brushStep));
    } else if (event.key() == Qt::Key_Backspace) {
        path_.undoStep(guide_ ? &guide_->liveWire : nullptr);
        view().redraw();
    } else {
        finishPath();
    }
}

bool EditCurvesTool::undoStep()
{
    const bool wasDrawing = !path_.isEmpty();
    path_.clear();
    return wasDrawing;
}

}   // namespace angiopose::ui
