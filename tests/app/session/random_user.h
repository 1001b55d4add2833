#pragma once

#include "app/window_host.h"
#include "tests/app/session/tool_preference.h"

namespace angiopose::test {

/// A user who does anything the window allows, in random order, by real mouse and key events. The same seed always
/// makes the same choices.
class RandomUser {
public:
    RandomUser(app::WindowHost& host, std::uint64_t seed);

    void act();   ///< one action, some in the dialog it opened, and that closed again
    /// Ends tools, runs and trials; whatever is computed for the case has arrived. False: something does not end.
    [[nodiscard]] bool comeToRest();
    const QString& lastAction() const { return last_; }

private:
    Desk desk();
    QString doSomething();
    void closeDialogs();
    void putWindowBack();

    app::WindowHost& host_;
    RandomHand hand_;
    QString folder_;
    QByteArray layout_;   ///< of the window as it was found
    std::vector<ToolPreference> preferences_;
    int totalWeight_ = 0;
    QString last_;
};

}   // namespace angiopose::test