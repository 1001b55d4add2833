#pragma once

#include "app/window_host.h"
#include "tests/app/session/tool_preference.h"

namespace angiopose::test {

/// A user who performs any action the window allows, in random order, by real mouse and key events. The same seed
/// always makes the same choices.
class RandomUser {
public:
    RandomUser(app::WindowHost& host, std::uint64_t seed);

    void act();   ///< one action, including some in a dialog that it opens, which is then closed
    /// Ends tools, registrations and trials and waits for all pending results. Returns false if something does not end.
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
    QByteArray layout_;   ///< initial layout of the window
    std::vector<ToolPreference> preferences_;
    int totalWeight_ = 0;
    QString last_;
};

}   // namespace angiopose::test
