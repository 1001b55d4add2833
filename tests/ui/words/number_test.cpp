#include "ui/words/number.h"

#include "ui/words/language.h"

#include <gtest/gtest.h>

namespace angiopose::ui {
namespace {

class Number : public ::testing::Test {
protected:
    void TearDown() override { applyLanguage(QStringLiteral("en")); }
};

TEST_F(Number, HasTheDecimalSignOfTheLanguage)
{
    for (const auto& [code, fixed, brief] : {std::tuple{"en", "−12.50", "0.01"}, std::tuple{"de", "−12,50", "0,01"},
                                             std::tuple{"zh_CN", "−12.50", "0.01"}}) {
        applyLanguage(QString::fromLatin1(code));
        EXPECT_EQ(numberText(-12.5, 2), QString::fromUtf8(fixed)) << code;
        EXPECT_EQ(briefNumber(0.01, 3), QString::fromLatin1(brief)) << code;
        EXPECT_EQ(numberText(12345.6, 0), QStringLiteral("12346")) << "no groups: they read like a decimal sign";
    }
}

TEST_F(Number, HasNoSignWhereItRoundsToNothing)
{
    EXPECT_EQ(numberText(-0.04, 1), QStringLiteral("0.0"));
    EXPECT_EQ(numberText(-0.06, 1), QStringLiteral("−0.1"));
    EXPECT_EQ(numberText(-0.4, 0), QStringLiteral("0"));
}

TEST_F(Number, AndSentencesStandInARowAsTheLanguageHasThem)
{
    EXPECT_EQ(joinSentences({QStringLiteral("One."), QStringLiteral("Two.")}), QStringLiteral("One. Two."));
    EXPECT_EQ(joinNames({QStringLiteral("A"), QStringLiteral("B")}), QStringLiteral("A, B"));
    applyLanguage(QStringLiteral("zh_CN"));
    EXPECT_EQ(joinSentences({QStringLiteral("一。"), QStringLiteral("二。")}), QStringLiteral("一。二。"));
    EXPECT_EQ(joinSentences({QStringLiteral("One."), QStringLiteral("二。")}), QStringLiteral("One. 二。"));
    EXPECT_EQ(joinNames({QStringLiteral("A"), QStringLiteral("B")}), QStringLiteral("A、B"));
}

TEST_F(Number, IsUnderstoodWithEitherSignInEveryLanguage)
{
    for (const QString& code : languages()) {
        applyLanguage(code);
        EXPECT_EQ(numberFrom(QStringLiteral("2,5")), 2.5);
        EXPECT_EQ(numberFrom(QStringLiteral(" −2.5 ")), -2.5);
        EXPECT_EQ(numberFrom(QStringLiteral("1.2.3")), std::nullopt);
        EXPECT_EQ(numberFrom(QStringLiteral("inf")), std::nullopt);
        EXPECT_EQ(numberFrom({}), std::nullopt);
    }
}

TEST_F(Number, NamesKeepTheirPoints)
{
    applyLanguage(QStringLiteral("de"));
    EXPECT_EQ(withDecimalSign(QStringLiteral("LAO 31.3 · CRA 0.1")), QStringLiteral("LAO 31,3 · CRA 0,1"));
    EXPECT_EQ(withDecimalSign(QStringLiteral("0.391 mm/px")), QStringLiteral("0,391 mm/px"));
    EXPECT_EQ(withDecimalSign(QStringLiteral("12.5°")), QStringLiteral("12,5°"));
    for (const char* name : {"scan 1.5.nrrd", "/data/ct 0.6 mm", "1.2.840.10008", "IM3.dcm", "version 0.1.0", ""}) {
        EXPECT_EQ(withDecimalSign(QString::fromLatin1(name)), QString::fromLatin1(name));
    }
}

}   // namespace
}   // namespace angiopose::ui
