#include "tests/support/eventually.h"
#include "widgets/fuzzy/rule_notes.h"

#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

using namespace esm;

TEST(RuleNotes, AreAsHighAsTheirTextNeeds) {
    RuleNotes notes;
    notes.setNotes({{RuleNote::Kind::Warning, "short"},
                    {RuleNote::Kind::Mistake, QString("a rule that cannot be read ").repeated(6)},
                    {RuleNote::Kind::Mistake, QString("x").repeated(5000)}});
    notes.resize(300, 200);
    notes.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&notes, patience));
    const auto height = [&](int row) { return notes.visualItemRect(notes.item(row)).height(); };
    const int wide = height(1);
    EXPECT_GE(wide, height(0) + 2 * notes.fontMetrics().lineSpacing());
    EXPECT_LT(notes.item(2)->text().size(), 1000) << "no more than anyone reads";
    notes.resize(200, 200);
    QTest::qWait(0);
    EXPECT_TRUE(QTest::qWaitFor([&] { return height(1) > wide; }, patience));
}

TEST(RuleNotes, LeadToTheirPlaces) {
    RuleNotes notes;
    notes.setNotes({{RuleNote::Kind::Mistake, "there", 4, 7}, {RuleNote::Kind::Warning, "nowhere"}});
    notes.resize(300, 200);
    notes.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&notes, patience));
    QSignalSpy picked(&notes, &RuleNotes::placePicked);
    for (const int row : {0, 1})
        QTest::mouseClick(notes.viewport(), Qt::LeftButton, {},
                          notes.visualItemRect(notes.item(row)).center());
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked[0][0].toInt(), 4);
    EXPECT_EQ(picked[0][1].toInt(), 7);
}
