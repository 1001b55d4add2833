#include "app/messages/catalog.h"
#include "core/messages/catalog.h"
#include "io/messages/catalog.h"
#include "ui/words/language.h"

#include <gtest/gtest.h>

#include <QRegularExpression>
#include <QTranslator>

#include <set>

namespace angiopose::app {
namespace {

std::vector<const core::MessageEntry*> allEntries()
{
    std::vector<const core::MessageEntry*> all;
    for (const auto& catalog : {core::messageCatalog(), io::messageCatalog(), messageCatalog()}) {
        all.insert(all.end(), catalog.begin(), catalog.end());
    }
    return all;
}

/// Placeholders "%1", "%2", … of a sentence, in order.
QStringList placesOf(const QString& sentence)
{
    QStringList places;
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    for (auto found = place.globalMatch(sentence); found.hasNext();) {
        places << found.next().captured();
    }
    places.removeDuplicates();
    places.sort();
    return places;
}

TEST(MessageCatalog, NamesEveryMessageOnceInOneStyle)
{
    static const QRegularExpression style(QStringLiteral("^[a-z]+(-[a-z]+)*\\.[a-z0-9]+(-[a-z0-9]+)*$"));
    std::set<std::string> ids;
    for (const core::MessageEntry* entry : allEntries()) {
        EXPECT_TRUE(ids.insert(entry->id).second) << entry->id << " is there twice";
        EXPECT_TRUE(style.match(QString::fromUtf8(entry->id)).hasMatch()) << entry->id;
    }
    EXPECT_GT(ids.size(), 400U);
}

TEST(MessageCatalog, IsWhollyTranslatedWithEveryArgument)
{
    ui::applyLanguage(QStringLiteral("en"));   // loads the translations
    for (const QString& code : {QStringLiteral("de"), QStringLiteral("zh_CN")}) {
        QTranslator translator;
        ASSERT_TRUE(translator.load(QStringLiteral(":/translations/angiopose_%1.qm").arg(code)));
        for (const core::MessageEntry* entry : allEntries()) {
            const QString translated = translator.translate("messages", entry->english, entry->id);
            EXPECT_EQ(placesOf(translated), placesOf(QString::fromUtf8(entry->english)))
                << code.toStdString() << ": " << entry->id << ": " << translated.toStdString();
            EXPECT_FALSE(translated.isEmpty()) << code.toStdString() << ": " << entry->id;
        }
    }
}

}   // namespace
}   // namespace angiopose::app
