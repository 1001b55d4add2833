#pragma once

#include "core/registration/options/registration_options.h"
#include "ui/controls/section.h"
#include "ui/words/retranslation.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QPushButton;

namespace angiopose::ui {

class OptionForm;

/// Panel with the registration method, its options, Register and Stop. Passive view: displays the given state and
/// emits signals for user actions.
class RegistrationPanel : public Section {
    Q_OBJECT
public:
    explicit RegistrationPanel(QWidget* parent = nullptr);

    void showOptions(const core::RegistrationOptions& options);   ///< emits no signal
    void showAuxiliary(int branchCount);   ///< number of auxiliary branches; if 0, the auxiliary problem uses the nodes
    void showViewCount(int count);   ///< number of views for joint registration; 1 hides the option
    void showBlockingReason(const QString& whyNot);   ///< reason why Register is disabled; if empty, it is enabled
    void setRunning(bool running);
    QPushButton* registerButton() const { return register_; }

signals:
    void optionsEdited(const core::RegistrationOptions& options, const ui::LocalizedText& fieldLabel);
    void registerRequested();
    void stopRequested();
    void allViewsToggled(bool allViews);

private:
    void showLocks(int count);
    QHBoxLayout* methodRow();
    void chooseMethod(int index);
    void updateTexts();
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
    QString blockingReason_;
    int auxiliaryCount_ = 0;
    int viewCount_ = 1;
    bool running_ = false;
};

}   // namespace angiopose::ui
