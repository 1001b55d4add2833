#pragma once

#include "app/document/case_document.h"

#include "ui/words/retranslation.h"

#include <QUndoCommand>

#include <tuple>
#include <utility>

namespace angiopose::app {

/// Merge ID of an edit that never merges with another; see SetFields.
inline constexpr int noMergeId = -1;

/// Edit whose name follows the UI language.
class NamedEdit : public QUndoCommand {
public:
    explicit NamedEdit(ui::LocalizedText name) : QUndoCommand(name()), name_(std::move(name)) {}
    QString name() const { return name_(); }

private:
    ui::LocalizedText name_;
};

/// Returns the part of a case that owns a field: the case, its vessels or its shown view.
template <class Value>
auto& ownerOf(core::Case& session, Value core::Case::*)
{
    return session;
}
template <class Value>
auto& ownerOf(core::Case& session, Value core::Vessels::*)
{
    return session.vessels;
}
template <class Value>
auto& ownerOf(core::Case& session, Value core::View::*)
{
    return session.shown();
}

/// Yields the value type of a pointer to member.
template <class Owner, class Value>
Value valueOf(Value Owner::*);

/// Undoable change of fields of the open case, its vessels or its shown view. `Case::shownView` may change only
/// together with `Case::views`. Edits with the same burst number merge into one step. stack.push(new
/// SetFields<&core::View::frame>(document, {4}, [] { return tr("Show frame 4"); }));
template <auto... Fields>
class SetFields : public NamedEdit {
public:
    using Values = std::tuple<decltype(valueOf(Fields))...>;

    SetFields(CaseDocument& document, Values values, ui::LocalizedText name, int mergeId = noMergeId)
        : NamedEdit(std::move(name)), document_(document), swapValues_(std::move(values)), mergeId_(mergeId)
    {
    }

    /// Reads the values of the fields in `wanted`.
    static Values valuesOf(core::Case wanted) { return {std::move(ownerOf(wanted, Fields).*Fields)...}; }

    void redo() override { swapWithDocument(); }
    void undo() override { swapWithDocument(); }
    int id() const override { return mergeId_; }

    /// Merges without copying: the document holds the later values, and `swapValues_` those from before the burst.
    bool mergeWith(const QUndoCommand* later) override { return dynamic_cast<const SetFields*>(later) != nullptr; }

private:
    void swapWithDocument()
    {
        std::apply([this](auto&... other) { (std::swap(ownerOf(document_.case_, Fields).*Fields, other), ...); },
                   swapValues_);
        emit document_.changed();
    }

    CaseDocument& document_;
    Values swapValues_;   ///< values that undo or redo will swap into the document
    int mergeId_;
};

}   // namespace angiopose::app
