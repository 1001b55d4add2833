#pragma once

#include "app/document/case_document.h"

#include "ui/words/spoken.h"

#include <QUndoCommand>

#include <tuple>
#include <type_traits>
#include <utility>

namespace angiopose::app {

/// Unique numbers for edits that belong together; see SetFields.
inline constexpr int separateEdit = -1;

/// An edit that says its name in whatever language the window speaks when it is asked.
class NamedEdit : public QUndoCommand {
public:
    explicit NamedEdit(ui::Words name) : QUndoCommand(name()), name_(std::move(name)) {}
    QString name() const { return name_(); }

private:
    ui::Words name_;
};

/// The part of a case that has a field: the case itself, its vessels, its shown view.
template <class Value>
auto& partWith(core::Case& session, Value core::Case::*)
{
    return session;
}
template <class Value>
auto& partWith(core::Case& session, Value core::Vessels::*)
{
    return session.vessels;
}
template <class Value>
auto& partWith(core::Case& session, Value core::View::*)
{
    return session.shown();
}

/// What a pointer to a member points to.
template <class Owner, class Value>
Value valueOf(Value Owner::*);

/// Undoable change of some fields of the open case: of itself, its vessels or its shown view. Which view is shown may
/// change with `Case::views` as a whole only. Edits with the same burst number merge into one step.
///   stack.push(new SetFields<&core::View::frame>(document, {4}, [] { return tr("Show frame 4"); }));
template <auto... Fields>
class SetFields : public NamedEdit {
public:
    using Values = std::tuple<decltype(valueOf(Fields))...>;

    SetFields(CaseDocument& document, Values values, ui::Words name, int burst = separateEdit)
        : NamedEdit(std::move(name)), document_(document), others_(std::move(values)), burst_(burst)
    {
    }

    /// The fields as they are in `wanted`.
    static Values valuesOf(core::Case wanted) { return {std::move(partWith(wanted, Fields).*Fields)...}; }

    void redo() override { swapWithDocument(); }
    void undo() override { swapWithDocument(); }
    int id() const override { return burst_; }

    /// The document already shows the later values, and `others_` keeps those from before the burst.
    bool mergeWith(const QUndoCommand* later) override { return dynamic_cast<const SetFields*>(later) != nullptr; }

private:
    void swapWithDocument()
    {
        std::apply([this](auto&... other) { (std::swap(partWith(document_.case_, Fields).*Fields, other), ...); },
                   others_);
        emit document_.changed();
    }

    CaseDocument& document_;
    Values others_;   ///< the values not in the document right now
    int burst_;
};

}   // namespace angiopose::app