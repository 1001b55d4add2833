#include "ui/slices/seed_list.h"

#include "ui/controls/number_field.h"

#include <gtest/gtest.h>
#include <QCheckBox>
#include <QSignalSpy>
#include <QSlider>

using namespace angiopose::ui;

namespace {

struct OpenThreshold {
    OpenThreshold() { field.showRange({-200.0, 1200.0}, true); }

    ThresholdField field;
    NumberField& number = *field.findChild<NumberField*>();
    QSlider& slider = *field.findChild<QSlider*>();
    QCheckBox& automatic = *field.findChildren<QCheckBox*>().front();
};

}   // namespace

TEST(ThresholdField, CallsTheValuesOfCtAloneHounsfieldUnits)
{
    OpenThreshold open;
    EXPECT_GT(open.number.textMargins().right(), 0);   // space for "HU"
    open.field.showRange({0.0, 900.0}, false);
    EXPECT_EQ(open.number.textMargins().right(), 0);
    EXPECT_EQ(open.slider.maximum(), 900);
}

TEST(ThresholdField, BeginsAtWhatWasFound)
{
    OpenThreshold open;
    open.field.showAutomatic(231.0);
    EXPECT_EQ(open.field.shown(), 231.0);
    EXPECT_FALSE(open.slider.isEnabled());
    EXPECT_FALSE(open.field.isPreviewWanted());

    const QSignalSpy thresholdChosen(&open.field, &ThresholdField::thresholdChosen);
    open.automatic.setChecked(false);
    EXPECT_EQ(thresholdChosen.count(), 1);
    EXPECT_TRUE(open.slider.isEnabled());
    EXPECT_EQ(open.slider.value(), 231);
    EXPECT_TRUE(open.field.isPreviewWanted());
    open.slider.setValue(300);
    EXPECT_EQ(open.field.shown(), 300.0);
    open.automatic.setChecked(true);
    EXPECT_EQ(open.field.shown(), 231.0);
}
