#include "ui/help/help_page.h"

#include "core/registration/methods/method_info.h"
#include "core/registration/options/option_fields.h"
#include "ui/panels/registration_panel.h"

#include <gtest/gtest.h>
#include <QTextBrowser>
#include <QToolButton>

namespace angiopose::ui {
namespace {

QString text(std::string_view view)
{
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

QString methodPage(const QString& id)
{
    return HelpPage::markdown(QStringLiteral("methods/") + id);
}

TEST(MethodHelp, EveryMethodHasAPageThatSaysWhatItShould)
{
    for (const core::MethodInfo& info : core::methodInfos()) {
        const QString page = methodPage(text(info.id));
        EXPECT_TRUE(page.startsWith(QStringLiteral("# ") + text(info.label) + QLatin1Char('\n'))) << info.id;
        for (const char* heading : {"## What it minimizes", "## When it fails", "## Source"}) {
            EXPECT_TRUE(page.contains(QLatin1String(heading))) << info.id << ": " << heading;
        }
    }
    EXPECT_TRUE(methodPage(QStringLiteral("no-such-method")).isEmpty());
}

// A help page may only mention settings of its method, under the names shown in the window.
TEST(MethodHelp, PagesNameSettingsAsTheWindowDoes)
{
    for (const core::MethodInfo& info : core::methodInfos()) {
        const QString settings = methodPage(text(info.id))
                                     .section(QStringLiteral("## Settings"), 1)
                                     .section(QStringLiteral("## Source"), 0, 0);
        const QStringList parts = settings.split(QLatin1Char('*'));
        for (qsizetype i = 1; i < parts.size(); i += 2) {
            bool isThere = false;
            for (const core::OptionField& field : core::optionFields()) {
                isThere = isThere || (core::appliesTo(field, info.id) && text(field.label) == parts[i]);
            }
            EXPECT_TRUE(isThere) << info.id << ": " << parts[i].toStdString();
        }
    }
}

TEST(MethodHelp, OpensForTheChosenMethod)
{
    RegistrationPanel panel;
    core::RegistrationOptions options;
    options.method = "dt-icp";
    panel.showOptions(options);
    panel.show();
    for (auto* button : panel.findChildren<QToolButton*>()) {
        if (button->accessibleName() == QStringLiteral("About this method")) {
            button->click();
        }
    }
    auto* help = panel.findChild<HelpPage*>();
    ASSERT_NE(help, nullptr);
    EXPECT_TRUE(help->findChild<QTextBrowser*>()->toPlainText().startsWith(QStringLiteral("DT-ICP")));
    help->close();
}

}   // namespace
}   // namespace angiopose::ui
