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

/// Undoable change of some fields of the open case. Edits with the same burst number merge into one step.
///   stack.push(new SetFields<&core::RegistrationCase::frame>(document, {4}, [] { return tr("Show frame 4"); }));
template <auto... Fields>
class SetFields : public NamedEdit {
public:
    using Values = std::tuple<std::decay_t<decltype(std::declval<core::RegistrationCase>().*Fields)>...>;

    SetFields(CaseDocument& document, Values values, ui::Words name, int burst = separateEdit)
        : NamedEdit(std::move(name)), document_(document), others_(std::move(values)), burst_(burst)
    {
    }

    /// The fields as they are in `wanted`.
    static Values valuesOf(const core::RegistrationCase& wanted) { return {wanted.*Fields...}; }

    void redo() override { swapWithDocument(); }
    void undo() override { swapWithDocument(); }
    int id() const override { return burst_; }

    /// The document already shows the later values, and `others_` keeps those from before the burst.
    bool mergeWith(const QUndoCommand* later) override { return dynamic_cast<const SetFields*>(later) != nullptr; }

private:
    void swapWithDocument()
    {
        std::apply([this](auto&... other) { (std::swap(document_.case_.*Fields, other), ...); }, others_);
        emit document_.changed();
    }

    CaseDocument& document_;
    Values others_;   ///< the values not in the document right now
    int burst_;
};

}   // namespace angiopose::app