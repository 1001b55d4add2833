#pragma once

#include "core/registration/options/registration_options.h"
#include "ui/controls/section.h"
#include "ui/words/spoken.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QPushButton;

namespace angiopose::ui {

class OptionForm;

/// Method, options, Register and Stop. Displays the values it is given and emits signals for user actions; makes no
/// decisions.
class RegistrationPanel : public Section {
    Q_OBJECT
public:
    explicit RegistrationPanel(QWidget* parent = nullptr);

    void showOptions(const core::RegistrationOptions& options);   ///< emits no signal
    void showAuxiliary(int branchCount);   ///< 0: the auxiliary problem uses the nodes
    void showViewCount(int count);   ///< views available for joint registration; 1 hides the choice
    void showReady(const QString& whyNot);   ///< empty: Register is enabled
    void setRunning(bool running);
    QPushButton* registerButton() const { return register_; }

signals:
    void optionsEdited(const core::RegistrationOptions& options, const ui::Words& fieldLabel);
    void registerRequested();
    void stopRequested();
    void allViewsToggled(bool together);

private:
    void showLocks(int count);
    QHBoxLayout* methodRow();
    void chooseMethod(int index);
    void sayWords();
    void updateButtons();

    core::RegistrationOptions options_;
    QComboBox* method_;
    QLabel* summary_;
    OptionForm* form_;
    Section* optionSection_;
    QPushButton* register_;
    QPushButton* stop_;
    QLabel* lockNote_;
    QCheckBox* allViews_;
    QString whyNot_;
    int auxiliaryCount_ = 0;
    int viewCount_ = 1;
    bool running_ = false;
};

}   // namespace angiopose::ui