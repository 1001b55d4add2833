#pragma once

#include "core/registration/options/option_fields.h"
#include "ui/words/retranslation.h"

#include <QWidget>

#include <functional>
#include <vector>

class QFormLayout;

namespace angiopose::ui {

/// Form with an editor for each option of the selected method, built from core::optionFields().
class OptionForm : public QWidget {
    Q_OBJECT
public:
    explicit OptionForm(QWidget* parent = nullptr);

    void showOptions(const core::RegistrationOptions& options);   ///< emits no signal; rebuilds if the method changed

signals:
    void edited(const core::RegistrationOptions& options, const ui::LocalizedText& fieldLabel);

private:
    void rebuild();
    QWidget* makeEditor(const core::OptionField& field);
    QWidget* makeSwitch(const core::OptionField& field);
    QWidget* makeChoice(const core::OptionField& field);
    QWidget* makeNumber(const core::OptionField& field, const core::NumberOption& number);
    void write(const core::OptionField& field, const core::OptionValue& value);

    core::RegistrationOptions options_;
    QFormLayout* form_;
    std::string displayedMethod_;
    std::vector<std::function<void()>> refreshers_;   ///< one function per editor, which updates the displayed value
};

}   // namespace angiopose::ui
